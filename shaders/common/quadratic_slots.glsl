// Slots in which the vertices of a quadratic tet (common/quadratic_tet.glsl) get values that they gather.
INPUT_UVEC4(QuadraticSlots, quadratic_slots)  // [3 * quadratic_count] of the corners; of the middles of 01, 12, 02, 03; of 13, 23
OUTPUT(vec4, Correction, correction)          // [slots]
