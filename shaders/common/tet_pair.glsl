// Two tets that share a face, or one by itself: what the two have in common is read and written once. Invocations go through the pairs
// first and through the single tets after them.
// The corners of a pair are s0, s1, s2 of the face, x of tet a = (s0, s1, s2, x) and y of tet b = (s0, s2, s1, y). Of a single tet b is
// a copy of a whose shape functions are zero: it adds nothing to any force, and what it would write is left out.
#include "common/tet.glsl"
uniform uint pair_count;  // before the single tets

struct TetPair {
  uint ta, tb;  // tb = ta of a single tet
  bool two;
  Tet a, b;
};

TetPair load_pair(uint i) {
  bool two = i < pair_count;
  uint ta = two ? 2u * i : pair_count + i, tb = two ? ta + 1u : ta;
  Tet a = load_tet(ta), b = load_tet(tb);
  float weight = two ? 1.0 : 0.0;
  return TetPair(ta, tb, two, a, Tet(b.v, weight * b.b1, weight * b.b2, weight * b.b3, b.volume));
}

// The gradients of a vector at the vertices in both tets.
struct PairGradient {
  mat3 a, b;
};

PairGradient gradients(TetPair pair, vec3 s0, vec3 s1, vec3 s2, vec3 x, vec3 y) {
  return PairGradient(displacement_gradient(pair.a, s0, s1, s2, x), displacement_gradient(pair.b, s0, s2, s1, y));
}

#define GRADIENTS(pair, field)                                                                                    \
  gradients(pair, FETCH(field, pair.a.v.x).xyz, FETCH(field, pair.a.v.y).xyz, FETCH(field, pair.a.v.z).xyz, \
            FETCH(field, pair.a.v.w).xyz, FETCH(field, pair.b.v.w).xyz)
