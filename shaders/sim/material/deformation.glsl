// The deformation that the strain-based models use for a tet with displacement gradient H: F and the Green strain. With
// signed_st_venant_kirchhoff, where a direction is compressed below LEAST_STRETCH or the tet is inverted, they are
// replaced: F by that of singular values that are no smaller, and the strains by their continuation along the tangent
// (sim/material/st_venant_kirchhoff.h). In St. Venant-Kirchhoff's formulas these give the forces of that material.
#include "common/symmetric.glsl"
#include "common/tet.glsl"
#include "sim/elasticity/feature_material.glsl"

struct Deformation {
  mat3 f;
  Sym3 e;
};

#if SIGNED_ST_VENANT_KIRCHHOFF
#include "common/svd.glsl"
#define LEAST_STRETCH 0.6
// Few tets need the decomposition, which is expensive. DEFERS: they are put on a list, and the kernel processes the
// upright ones. DEFERRED: the kernel processes that list. GUARDED_ELSEWHERE: the kernel treats them in another way.

// Whether all singular values are above LEAST_STRETCH and none is negative, by Sylvester's criterion for F^T F = I + 2
// e.
bool upright(mat3 h, Sym3 e) {
  vec3 d = (1.0 - LEAST_STRETCH * LEAST_STRETCH) + 2.0 * e.d, s = 2.0 * e.s;
  float minor = d.x * d.y - s.z * s.z;
  return d.x > 0.0 && minor > 0.0 && minor * d.z + 2.0 * s.x * s.y * s.z - d.x * s.x * s.x - d.y * s.y * s.y > 0.0 &&
         det_f_minus_one(h) > -1.0;
}

Deformation guarded(mat3 f, bool wanted) {
  Svd svd = signed_svd(f, wanted);
  vec3 slope = max(svd.s, LEAST_STRETCH);
  vec3 e = 0.5 * (slope * slope - 1.0) + LEAST_STRETCH * min(svd.s - LEAST_STRETCH, 0.0);
  vec3 r0 = vec3(svd.v[0].x, svd.v[1].x, svd.v[2].x), r1 = vec3(svd.v[0].y, svd.v[1].y, svd.v[2].y),
       r2 = vec3(svd.v[0].z, svd.v[1].z, svd.v[2].z);
  return Deformation(mat3(slope.x * svd.u[0], slope.y * svd.u[1], slope.z * svd.u[2]) * transpose(svd.v),
                     Sym3(vec3(dot(r0 * e, r0), dot(r1 * e, r1), dot(r2 * e, r2)),
                          vec3(dot(r1 * e, r2), dot(r0 * e, r2), dot(r0 * e, r1))));
}

bool needs_guard(mat3 h, vec4 material) { return IS_SIGNED_ST_VENANT_KIRCHHOFF(material) && !upright(h, green_strain(h)); }
#endif

#ifdef DEFERS
#define DEFER_GUARDED(i, pair, h) \
  if (needs_guard(h.a, material_of(pair.ta)) || needs_guard(h.b, material_of(pair.tb))) { defer(i); return; }
#else
#define DEFER_GUARDED(i, pair, h)
#endif

Deformation deformation_of(mat3 h, vec4 material) {
  Deformation plain = Deformation(mat3(1.0) + h, green_strain(h));
#if SIGNED_ST_VENANT_KIRCHHOFF && !defined DEFERS && !defined GUARDED_ELSEWHERE
  bool needed = needs_guard(h, material);
  if (needed) return guarded(plain.f, needed);
#endif
  return plain;
}
