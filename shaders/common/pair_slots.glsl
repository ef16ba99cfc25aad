// Slots in which the corners of a pair of tets (common/tet_pair.glsl) store values that vertices gather.
INPUT_UVEC4(PairSlots, pair_slots)    // [pairs and single tets] slots of s0, s1, s2, x; that of y is stored with the
                                      // pair
OUTPUT(vec4, Correction, correction)  // [slots]
