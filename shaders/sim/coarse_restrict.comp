// To the coarse space: the gradient that every coarse node sees, r_j = sum_a P_aj g_a, and the mean deformation gradient around it
// without its identity, M_j - I = sum_a u_a c_ja^T. `lanes` invocations share a node. After gradient.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(GatherBegin, gather_begin)    // [node_count + 1]
INPUT_UINT(GatherVertex, gather_vertex)  // [entries]
INPUT_VEC4(GatherEntry, gather_entry)    // [entries] xyz c_ja [1/m], w P_aj
INPUT_VEC4(Gradient, gradient)           // [vertex_count] g [kg m]
INPUT_VEC4(Displacement, displacement)   // [vertex_count] u [m]
OUTPUT(vec4, CoarsePartials, coarse_partials)  // [3 * invocations] columns of M_j - I, with r_j in the w
uniform uint lanes;

void main() {
  ITEM_OR_RETURN(i)
  uint node = i / lanes, end = FETCH1(gather_begin, node + 1u);
  vec3 r = vec3(0.0), m0 = vec3(0.0), m1 = vec3(0.0), m2 = vec3(0.0);
  for (uint k = FETCH1(gather_begin, node) + i % lanes; k < end; k += lanes) {
    uint v = FETCH1(gather_vertex, k);
    vec4 entry = FETCH(gather_entry, k);
    vec3 u = FETCH(displacement, v).xyz;
    r += entry.w * FETCH(gradient, v).xyz;
    m0 += entry.x * u;
    m1 += entry.y * u;
    m2 += entry.z * u;
  }
  coarse_partials[3u * i] = vec4(m0, r.x);
  coarse_partials[3u * i + 1u] = vec4(m1, r.y);
  coarse_partials[3u * i + 2u] = vec4(m2, r.z);
}
