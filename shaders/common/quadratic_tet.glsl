// A quadratic tet (sim/elements/quadratic_tet.h): its ten vertices, and the displacement gradients H at its four points,
// from those at its corners, of which H is a mean everywhere.
// Quadratic tets are counted on their own: tet number FIRST_QUADRATIC + e is quadratic tet e.
#include "common/tet.glsl"
INPUT_UVEC4(MidEdges, mid_edges)  // [2 * quadratic_count] vertices in the middle of the edges 01, 12, 02, 03 and 13, 23
#ifdef MIXED
uniform uint first_quadratic;  // the number of linear tets
#define FIRST_QUADRATIC first_quadratic
#else
#define FIRST_QUADRATIC 0u
#endif

// Where previous_strain has the strain of a point, behind those of linear tets (sim/elasticity/feature_damping.glsl).
#if READ_TEXELS
#define FIRST_OF_POINTS (2u * FIRST_QUADRATIC)
#else
#define FIRST_OF_POINTS (3u * ((FIRST_QUADRATIC + 1u) / 2u))
#endif
uint strain_of_point(uint e, int q) { return FIRST_OF_POINTS + 8u * e + 2u * uint(q); }

// Barycentric coordinates of a point: of the corner nearest to it, and of the others.
#define POINT_NEAR 0.58541019662
#define POINT_FAR 0.13819660113

struct PointGradients {
  mat3 at[4];
};

PointGradients corner_gradients(Tet tet, vec3 u0, vec3 u1, vec3 u2, vec3 u3, vec3 m01, vec3 m12, vec3 m02, vec3 m03, vec3 m13, vec3 m23) {
  vec3 b0 = -(tet.b1 + tet.b2 + tet.b3);
  vec3 d01 = u1 - u0, d02 = u2 - u0, d03 = u3 - u0, d12 = u2 - u1, d13 = u3 - u1, d23 = u3 - u2;
  PointGradients h;
  h.at[0] = outerProduct(4.0 * (m01 - u0) - d01, tet.b1) + outerProduct(4.0 * (m02 - u0) - d02, tet.b2) + outerProduct(4.0 * (m03 - u0) - d03, tet.b3);
  h.at[1] = outerProduct(4.0 * (m01 - u1) + d01, b0) + outerProduct(4.0 * (m12 - u1) - d12, tet.b2) + outerProduct(4.0 * (m13 - u1) - d13, tet.b3);
  h.at[2] = outerProduct(4.0 * (m02 - u2) + d02, b0) + outerProduct(4.0 * (m12 - u2) + d12, tet.b1) + outerProduct(4.0 * (m23 - u2) - d23, tet.b3);
  h.at[3] = outerProduct(4.0 * (m03 - u3) + d03, b0) + outerProduct(4.0 * (m13 - u3) + d13, tet.b1) + outerProduct(4.0 * (m23 - u3) + d23, tet.b2);
  return h;
}

PointGradients at_points(PointGradients corners) {
  mat3 far = POINT_FAR * (corners.at[0] + corners.at[1] + corners.at[2] + corners.at[3]);
  PointGradients h;
  for (int q = 0; q < 4; ++q) h.at[q] = far + (POINT_NEAR - POINT_FAR) * corners.at[q];
  return h;
}

// Of a vertex field in quadratic tet e.
#define CORNER_GRADIENTS(e, tet, field)                                                                                     \
  corner_gradients(tet, FETCH(field, tet.v.x).xyz, FETCH(field, tet.v.y).xyz, FETCH(field, tet.v.z).xyz,                    \
                   FETCH(field, tet.v.w).xyz, FETCH(field, FETCH(mid_edges, 2u * e).x).xyz,                                 \
                   FETCH(field, FETCH(mid_edges, 2u * e).y).xyz, FETCH(field, FETCH(mid_edges, 2u * e).z).xyz,              \
                   FETCH(field, FETCH(mid_edges, 2u * e).w).xyz, FETCH(field, FETCH(mid_edges, 2u * e + 1u).x).xyz,         \
                   FETCH(field, FETCH(mid_edges, 2u * e + 1u).y).xyz)
#define POINT_GRADIENTS(e, tet, field) at_points(CORNER_GRADIENTS(e, tet, field))

// The shape functions of a corner and of a middle at the centroid, and OF(v), of vertex v, at the centroid of a tet with the
// corners c and the middles m, n.
#define CORNER_AT_CENTROID -0.125
#define MIDDLE_AT_CENTROID 0.25
#define AT_CENTROID(OF, c, m, n)                                               \
  (MIDDLE_AT_CENTROID * (OF(m.x) + OF(m.y) + OF(m.z) + OF(m.w) + OF(n.x) + OF(n.y)) + \
   CORNER_AT_CENTROID * (OF(c.x) + OF(c.y) + OF(c.z) + OF(c.w)))

// Element q of four, and its new value. Graphics cards' compilers leave a loop that has no computed index as it is, and
// hold the numbers of one point at a time; on others such a loop is unrolled.
#if SUMS_IN_GROUPS
mat3 pick(PointGradients h, int q) {
  mat3 picked = h.at[0];
  if (q == 1) picked = h.at[1];
  if (q == 2) picked = h.at[2];
  if (q == 3) picked = h.at[3];
  return picked;
}
void put(inout PointGradients h, int q, mat3 value) {
  if (q == 0) h.at[0] = value;
  if (q == 1) h.at[1] = value;
  if (q == 2) h.at[2] = value;
  if (q == 3) h.at[3] = value;
}
#define PICK(h, q) pick(h, q)
#define PUT(h, q, value) put(h, q, value)
#else
#define PICK(h, q) h.at[q]
#define PUT(h, q, value) h.at[q] = value
#endif

mat3 at_point(PointGradients corners, int q) {
  mat3 far = POINT_FAR * (corners.at[0] + corners.at[1] + corners.at[2] + corners.at[3]);
  return far + (POINT_NEAR - POINT_FAR) * PICK(corners, q);
}

// AT_POINT: the gradient of a vertex field at point q, in a loop over the points. Graphics cards keep the numbers of one
// point and read the vertices again for the next, since those of all points are more than the registers of some; HELD
// has no gradients there. APART: a statement whose instructions do not mix with those around it, since it stands behind
// a condition, always true, that compilers do not know; what it needed is free behind it.
#define NO_GRADIENTS PointGradients(mat3[4](mat3(0.0), mat3(0.0), mat3(0.0), mat3(0.0)))
#if SUMS_IN_GROUPS
#define HELD(e, tet, field) NO_GRADIENTS
#define AT_POINT(held, e, tet, q, field) at_point(CORNER_GRADIENTS(e, tet, field), q)
#define APART(tet, statement) if (tet.volume > 0.0) { statement }
#else
#define HELD(e, tet, field) POINT_GRADIENTS(e, tet, field)
#define AT_POINT(held, e, tet, q, field) held.at[q]
#define APART(tet, statement) statement
#endif
