// Where the corners of a pair of tets (common/tet_pair.glsl) leave what vertices gather.
INPUT_UVEC4(PairSlots, pair_slots)        // [pairs and single tets] of s0, s1, s2, x
INPUT_UINT(PairFifthSlot, pair_fifth_slot)  // [the same] of y; of a single tet 0, which it leaves alone
