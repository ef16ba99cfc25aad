// What contact pushes back with at the coarse nodes that it touches, when these move as coarse_solve found without it:
// y = (I + C G)^-1 C x, with C the stiffness of contact there and G the part of the inverse between them (Woodbury's
// formula). It is subtracted from the right side, so that A_c^-1 (r - y) is the correction. The CPU computes the matrix
// (sim/coarse/coarse_contact.h). On GPUs a work group per node, else an invocation. After coarse_solve with TOUCHED.
#include "common/io.glsl"
#include "common/group_sum.glsl"
COMPUTE_1D
INPUT_UINT(CoarseTouched, coarse_touched)        // [0] the number of nodes, then the nodes
INPUT_VEC4(CoarseContact, coarse_contact)        // [3 * nodes * nodes] columns of the 3x3 blocks, row by row [kg]
INPUT_VEC4(CoarseScale, coarse_scale)            // [node_count] xyz of S [1/sqrt(kg)]
INPUT_VEC4(CoarseFree, coarse_free)              // [nodes] x [m]
INOUT(float, CoarseGradient, coarse_gradient)    // [3 * node_count] S R^T r becomes S (R^T r - y) [sqrt(kg) m]

void main() {
  SHARED_ITEM_OR_RETURN(i, lane)
  uint count = FETCH1(coarse_touched, 0u);
  if (i >= count) return;
  vec3 y = vec3(0.0);
  for (uint k = lane; k < count; k += LANES) {
    uint block = 3u * (i * count + k);
    vec3 x = FETCH(coarse_free, k).xyz;
    y += x.x * FETCH(coarse_contact, block).xyz + x.y * FETCH(coarse_contact, block + 1u).xyz + x.z * FETCH(coarse_contact, block + 2u).xyz;
  }
  SUM_OVER_LANES(y, lane)
  if (lane != 0u) return;
  uint node = FETCH1(coarse_touched, 1u + i);
  y *= FETCH(coarse_scale, node).xyz;
  coarse_gradient[3u * node] -= y.x;
  coarse_gradient[3u * node + 1u] -= y.y;
  coarse_gradient[3u * node + 2u] -= y.z;
}
