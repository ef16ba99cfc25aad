// To the coarse space: the gradient that every coarse node sees, r_j = sum_a P_aj g_a, and the mean deformation gradient around it
// without its identity, M_j - I = sum_a u_a c_ja^T. `lanes` invocations share a node. After gradient.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(GatherBegin, gather_begin)               // [node_count + 1]
INPUT_UVEC4(GatherEntry, gather_entry)              // [entries] xyz c_ja [1/m] (float bits), w vertex
INPUT_UINT(CoarseColumnBegin, coarse_column_begin)  // [node_count + 1]
INPUT_UVEC4(CoarseColumns, coarse_columns)          // two entries of P each: vertex and weight (float bits) in turn
INPUT_VEC4(Gradient, gradient)                      // [vertex_count] g [kg m]
INPUT_VEC4(Displacement, displacement)              // [vertex_count] u [m]
OUTPUT(vec4, CoarsePartials, coarse_partials)       // [3 * invocations] columns of M_j - I, with r_j in the w
uniform uint lanes;

void main() {
  ITEM_OR_RETURN(i)
  uint node = i / lanes, lane = i % lanes;
  vec3 m0 = vec3(0.0), m1 = vec3(0.0), m2 = vec3(0.0), r = vec3(0.0);
  uint end = FETCH1(gather_begin, node + 1u);
  for (uint k = FETCH1(gather_begin, node) + lane; k < end; k += lanes) {
    uvec4 entry = FETCH(gather_entry, k);
    vec3 c = uintBitsToFloat(entry.xyz), u = FETCH(displacement, entry.w).xyz;
    m0 += c.x * u;
    m1 += c.y * u;
    m2 += c.z * u;
  }
  end = FETCH1(coarse_column_begin, node + 1u);
  for (uint k = FETCH1(coarse_column_begin, node) + lane; k < end; k += lanes) {
    uvec4 entries = FETCH(coarse_columns, k);
    r += uintBitsToFloat(entries.y) * FETCH(gradient, entries.x).xyz;
    r += uintBitsToFloat(entries.w) * FETCH(gradient, entries.z).xyz;
  }
  coarse_partials[3u * i] = vec4(m0, r.x);
  coarse_partials[3u * i + 1u] = vec4(m1, r.y);
  coarse_partials[3u * i + 2u] = vec4(m2, r.z);
}
