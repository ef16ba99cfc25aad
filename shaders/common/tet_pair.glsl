// Two tets that share a face, or a single tet: data that the two have in common is read and written once. Invocations
// process the pairs first and then the single tets; tets are stored in that order, the second ones of pairs after all
// others. The corners of a pair are s0, s1, s2 of the face, x of tet a = (s0, s1, s2, x) and y of tet b = (s0, s2, s1,
// y). Along the face the gradients of both tets' shape functions agree, so that those of b differ from those of a by
// multiples of b_x, which is normal to it:
//   b_y = -c b_x,   b_s1 of b = b_s1 of a + d1 b_x,   b_s2 of b = b_s2 of a + d2 b_x,   V_b = V_a / c,
// and the gradients of a field differ by w b_x^T, w = d1 (s1 - s0) + d2 (s2 - s0) - (x - s0) - c (y - s0) of its
// values. Three numbers are read for the second tet instead of ten.
// For a single tet, b is a copy of a with zero shape functions: it adds nothing to any force, and its output is
// omitted.
#include "common/tet.glsl"
INPUT_UVEC4(PairFifth, pair_fifth)  // [pairs and single tets] the vertex y and its slot, c and V_b [m^3] (float bits);
                                    // for a single tet x, any, -1, V_a
uniform uint pair_count;    // number of pairs, which precede the single tets
uniform uint second_begin;  // index of the first pair's second tet

struct TetPair {
  uint ta, tb;  // for a single tet tb = ta
  bool two;
  Tet a, b;
  float c, d1, d2;
  uint fifth_slot;
};

// Tet b of two, from tet a: the same as in the pair, for kernels that need it late and hold less until then.
Tet second_of(TetPair pair) {
  Tet a = pair.a;
  return Tet(pair.b.v, a.b2 + pair.d2 * a.b3, a.b1 + pair.d1 * a.b3, -pair.c * a.b3, pair.b.volume);
}

TetPair load_pair(uint i) {
  bool two = i < pair_count;
  uint ta = i, tb = two ? second_begin + i : ta;
  vec4 r1 = FETCH(tet_shape, 3u * ta), r2 = FETCH(tet_shape, 3u * ta + 1u), r3 = FETCH(tet_shape, 3u * ta + 2u);
  uvec4 v = FETCH(tet_vertices, ta), fifth = FETCH(pair_fifth, i);
  float c = uintBitsToFloat(fifth.z), weight = two ? 1.0 : 0.0;
  Tet b = Tet(uvec4(v.xzy, fifth.x), weight * (r2.xyz + r3.w * r3.xyz), weight * (r1.xyz + r2.w * r3.xyz), -weight * c * r3.xyz,
              uintBitsToFloat(fifth.w));
  return TetPair(ta, tb, two, Tet(v, r1.xyz, r2.xyz, r3.xyz, r1.w), b, c, r2.w, r3.w, fifth.y);
}

// The gradients of a vertex field in both tets.
struct PairGradient {
  mat3 a, b;
};

// w of a field.
vec3 bend(TetPair pair, vec3 s0, vec3 s1, vec3 s2, vec3 x, vec3 y) {
  return pair.d1 * (s1 - s0) + pair.d2 * (s2 - s0) - (x - s0) - pair.c * (y - s0);
}

// The gradient in tet b, from that in tet a.
mat3 across(TetPair pair, mat3 a, vec3 w) {
  vec3 normal = pair.a.b3;
  return mat3(a[0] + w * normal.x, a[1] + w * normal.y, a[2] + w * normal.z);
}

PairGradient gradients(TetPair pair, vec3 s0, vec3 s1, vec3 s2, vec3 x, vec3 y) {
  mat3 a = displacement_gradient(pair.a, s0, s1, s2, x);
  return PairGradient(a, across(pair, a, bend(pair, s0, s1, s2, x, y)));
}

#define GRADIENTS(pair, field)                                                                                    \
  gradients(pair, FETCH(field, pair.a.v.x).xyz, FETCH(field, pair.a.v.y).xyz, FETCH(field, pair.a.v.z).xyz, \
            FETCH(field, pair.a.v.w).xyz, FETCH(field, pair.b.v.w).xyz)

// Of a vertex field in one tet.
#define GRADIENT(pair, second, field)                                                                                  \
  one_gradient(pair, second, FETCH(field, pair.a.v.x).xyz, FETCH(field, pair.a.v.y).xyz, FETCH(field, pair.a.v.z).xyz, \
               FETCH(field, pair.a.v.w).xyz, FETCH(field, pair.b.v.w).xyz)
mat3 one_gradient(TetPair pair, bool second, vec3 s0, vec3 s1, vec3 s2, vec3 x, vec3 y) {
  mat3 a = displacement_gradient(pair.a, s0, s1, s2, x);
  return second ? across(pair, a, bend(pair, s0, s1, s2, x, y)) : a;
}

// Both tets one after the other: `statement` for bool second = false and, where there are two, true. In a loop on
// graphics cards, whose compilers would otherwise hold numbers of both tets at once and spill some; on software
// renderers the loop costs more.
#if SUMS_IN_GROUPS
#define FOR_TETS_OF_PAIR(second, two, statement)          \
  for (uint tet_k = 0u; tet_k < ((two) ? 2u : 1u); ++tet_k) { \
    bool second = tet_k == 1u;                            \
    statement                                             \
  }
#else
#define FOR_TETS_OF_PAIR(second, two, statement) \
  {                                              \
    const bool second = false;                   \
    statement                                    \
  }                                              \
  if (two) {                                     \
    const bool second = true;                    \
    statement                                    \
  }
#endif
