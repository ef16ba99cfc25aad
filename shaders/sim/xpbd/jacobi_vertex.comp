// Averages the corrections of a vertex's tets: u += 1/n sum dx. A gather in fixed order, so runs repeat bit for bit.
// After jacobi_tet. This averaging is that of the I3D 2019 paper; its fixed point is softer than the material
// (docs/concepts/i3d2019.md).
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(SlotBegin, slot_begin)        // [vertex_count + 1]
INPUT_VEC4(Correction, correction)       // [slots] sorted by vertex
INPUT_UINT(CopyBegin, copy_begin)        // [vertex_count + 1] differences are the numbers of tets
#if EXACT
INPUT_VEC4(PrimalStep, primal_step)      // [vertex_count] xyz g/m^ [m], 0 where constrained
#endif
INPUT_VEC4_IN_PLACE(Iterate, iterate)    // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)

void main() {
  ITEM_OR_RETURN(i)
  uint begin = FETCH1(slot_begin, i), end = FETCH1(slot_begin, i + 1u);
  vec3 sum = vec3(0.0);
  for (uint k = begin; k < end; ++k) sum += FETCH(correction, k).xyz;
  vec3 step = end > begin ? sum / float(FETCH1(copy_begin, i + 1u) - FETCH1(copy_begin, i)) : vec3(0.0);
#if EXACT
  step -= FETCH(primal_step, i).xyz;
#endif
  displacement[i].xyz = FETCH_IN_PLACE(iterate, i).xyz + step;
}
