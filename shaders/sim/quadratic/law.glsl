// The law of a quadratic tet, split into a part at its points and one of its mean dilatation (volume_split() in
// sim/material/law.h):
//   E = V [mean Psi(F_q; lambda - K) + K/2 (mean theta(F_q))^2],  P_q = dPsi/dF_q + K (mean theta) dtheta/dF_q
// and the same for viscosity, with tr(E - E*) as theta.
#include "sim/material/invariants.glsl"
#include "sim/elasticity/elasticity.glsl"
#include "common/quadratic_tet.glsl"

struct VolumeSplit {
  vec4 pointwise;  // the material with lambda - K
  float bulk;      // K [Pa]
};

// RELAXED: what the iterations see of a large K (sim/quadratic/quadratic_multiplier.comp).
#ifdef RELAXED
INPUT_FLOAT(Multiplier, multiplier)  // [quadratic_count] q [Pa], or UNKNOWN_MULTIPLIER
#endif
#include "shared/relaxed_bulk.h"

// The pressure bulk * mean theta + multiplier, and its energy.
struct VolumeTerm {
  float bulk, multiplier;
};

float pointwise_lambda(vec4 material) {
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) return LAW_POINTWISE_LAMBDA(material);
#endif
  return 0.0;
}

VolumeSplit volume_split(vec4 material) {
  float mu = lame_mu(material), lambda = pointwise_lambda(material), bulk = lame_lambda(material) - lambda;
  float nu = lambda / (2.0 * (lambda + mu));
  if (bulk <= 0.0) return VolumeSplit(material, 0.0);
  return VolumeSplit(vec4(2.0 * mu * (1.0 + nu), nu, material.zw), bulk);
}

VolumeTerm volume_term_of(uint e, float bulk, vec4 material) {
#ifdef RELAXED
  float q = FETCH1(multiplier, e), relaxed = RELAXED_BULK * lame_mu(material);
  if (bulk > relaxed && q < UNKNOWN_MULTIPLIER) return VolumeTerm(relaxed, q);
#endif
  return VolumeTerm(bulk, 0.0);
}

#if SIGNED_ST_VENANT_KIRCHHOFF
bool needs_guard(PointGradients h, vec4 material) {
  return needs_guard(h.at[0], material) || needs_guard(h.at[1], material) || needs_guard(h.at[2], material) ||
         needs_guard(h.at[3], material);
}
#endif

struct Dilatation {
  float value;  // theta
  mat3 first;   // dtheta/dF
};

Dilatation dilatation_of(mat3 h, vec4 material) {
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) return Dilatation(det_f_minus_one(h), mat3(1.0) + cofactor_minus_one(h));
#endif
  Deformation d = deformation_of(h, material);
  return Dilatation(d.e.d.x + d.e.d.y + d.e.d.z, d.f);
}

// Second derivative of theta along a and b.
float dilatation_curvature(mat3 h, vec4 material, mat3 a, mat3 b) {
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) return inner(mat3(1.0) + h, tensor_cross(a, b));
#endif
  return inner(a, b);
}

float mean_dilatation(PointGradients h, vec4 material) {
  float sum = 0.0;
  for (int q = 0; q < 4; ++q) sum += dilatation_of(PICK(h, q), material).value;
  return 0.25 * sum;
}

#if DAMPING
struct Viscosity {
  float over_h;  // damping / h, faded
  float bulk;    // what multiplies the mean of tr(E - E*) [Pa]
  float mean;
};

Sym3 strain_since_start(uint e, int q, mat3 h) {
  Sym3 strain = green_strain(h), before = previous_strain_at(strain_of_point(e, q));
  return Sym3(strain.d - before.d, strain.s - before.s);
}

// Of the diagonal of E* and of tr(E - E*): sums over the points.
struct StrainMeans {
  vec3 before;
  float change;
};

void add_point(inout StrainMeans means, uint e, int q, mat3 h) {
  means.before += 0.25 * previous_strain_at(strain_of_point(e, q)).d;
  vec3 change = strain_since_start(e, q, h).d;
  means.change += 0.25 * (change.x + change.y + change.z);
}

Viscosity viscosity_of(StrainMeans means, vec4 material) {
  float over_h = damping_over_h(Sym3(means.before, vec3(0.0)), material);
  return Viscosity(over_h, over_h * max(viscous_lambda(material), 0.0), means.change);
}

Viscosity viscosity_of(uint e, PointGradients h, vec4 material) {
  StrainMeans means = StrainMeans(vec3(0.0), 0.0);
  for (int q = 0; q < 4; ++q) add_point(means, e, q, PICK(h, q));
  return viscosity_of(means, material);
}

// Second Piola stress at a point, without the mean.
Sym3 viscous_stress_at_point(Viscosity viscosity, Sym3 change, vec4 material) {
  float mu2 = 2.0 * lame_mu(material);
  return Sym3(viscosity.over_h * (mu2 * change.d + min(lame_lambda(material), 0.0) * (change.d.x + change.d.y + change.d.z)),
              viscosity.over_h * mu2 * change.s);
}
#endif

// What the response at a point needs of all points.
struct QuadraticLaw {
  VolumeSplit split;
  VolumeTerm volume;
  float mean;  // theta
#if DAMPING
  Viscosity viscosity;
#endif
};

QuadraticLaw law_of(uint e, PointGradients h, vec4 material) {
  QuadraticLaw law;
  law.split = volume_split(material);
  law.volume = volume_term_of(e, law.split.bulk, material);
  law.mean = mean_dilatation(h, material);
#if DAMPING
  law.viscosity = viscosity_of(e, h, material);
#endif
  return law;
}

float pressure_of(QuadraticLaw law) { return law.volume.bulk * law.mean + law.volume.multiplier; }

// Stress at a point, without viscosity, and the energy density without that of the mean.
Elastic elastic_at(QuadraticLaw law, mat3 h, vec4 material) {
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) {
    Elastic point = LAW_RESPONSE(h, law.split.pointwise);
    return Elastic(point.p + pressure_of(law) * dilatation_of(h, material).first, point.energy);
  }
#endif
  Deformation d = deformation_of(h, material);  // of the dilatation as of the rest
  Elastic point = strain_response(d, law.split.pointwise);
  return Elastic(point.p + pressure_of(law) * d.f, point.energy);
}

float energy_of_mean(QuadraticLaw law) { return (0.5 * law.volume.bulk * law.mean + law.volume.multiplier) * law.mean; }

// Over the gradients at the points it writes the stresses there, with viscosity. Returns the mean energy density.
float respond(uint e, inout PointGradients h, vec4 material) {
  QuadraticLaw law = law_of(e, h, material);
  float energy = energy_of_mean(law);
#if DAMPING
  float pressure = law.viscosity.bulk * law.viscosity.mean;
  vec4 viscous;  // density at the points
#endif
  for (int q = 0; q < 4; ++q) {
    mat3 at = PICK(h, q);
    Elastic point = elastic_at(law, at, material);
    energy += 0.25 * point.energy;
#if DAMPING
    Sym3 change = strain_since_start(e, q, at), s = viscous_stress_at_point(law.viscosity, change, material);
    viscous[q] = contract(s, change);
    s.d += pressure;
    point.p += times(mat3(1.0) + at, s);
#endif
    PUT(h, q, point.p);
  }
#if DAMPING
  energy += 0.5 * pressure * law.viscosity.mean;
  for (int q = 0; q < 4; ++q) energy += 0.125 * viscous[q];
#endif
  return energy;
}

// The forces on the vertices: derivatives of V mean Psi by their displacements, from the stresses at the points.
struct QuadraticForces {
  vec3 corner[4], middle[6];  // of the edges 01, 12, 02, 03, 13, 23
};

QuadraticForces forces_of(Tet tet, PointGradients p) {
  mat3 sum = p.at[0] + p.at[1] + p.at[2] + p.at[3];
  vec3 b[4] = vec3[4](-(tet.b1 + tet.b2 + tet.b3), tet.b1, tet.b2, tet.b3);
  mat3 at[4];  // sum_q L_c(q) P_q
  QuadraticForces f;
  for (int c = 0; c < 4; ++c) {
    at[c] = POINT_FAR * sum + (POINT_NEAR - POINT_FAR) * p.at[c];
    f.corner[c] = 0.25 * ((4.0 * at[c] - sum) * b[c]);
  }
  f.middle[0] = at[0] * b[1] + at[1] * b[0];
  f.middle[1] = at[1] * b[2] + at[2] * b[1];
  f.middle[2] = at[0] * b[2] + at[2] * b[0];
  f.middle[3] = at[0] * b[3] + at[3] * b[0];
  f.middle[4] = at[1] * b[3] + at[3] * b[1];
  f.middle[5] = at[2] * b[3] + at[3] * b[2];
  return f;
}
