#include "sim/reference/elasticity.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/material/law.h"
#include "sim/material/symmetric_eigen.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double energy_density(const Matrix3d& strain, double lambda, double mu) {
  const double trace = strain.trace();
  return 0.5 * lambda * trace * trace + mu * strain.squaredNorm();
}

Matrix3d second_piola_stress(const Matrix3d& strain, double lambda, double mu) {
  return lambda * strain.trace() * Matrix3d::Identity() + 2 * mu * strain;
}

bool is_st_venant_kirchhoff(const Matrix3d& f, const Material& material) {
  const MaterialLaw& law = law_of(material.model);
  return law.is_st_venant_kirchhoff && law.is_st_venant_kirchhoff(f);
}

}  // namespace

Matrix3d strain_of(const Matrix3d& h) { return 0.5 * (h + h.transpose() + h.transpose() * h); }

Vector6d green_strain(const Matrix3d& f) {
  const Matrix3d strain = strain_of(f - Matrix3d::Identity());
  Vector6d voigt;
  voigt << strain(0, 0), strain(1, 1), strain(2, 2), strain(1, 2), strain(0, 2), strain(0, 1);
  return voigt;
}

Matrix3d green_strain_matrix(const LinearTet& rest, const Corners& displacements) {
  return strain_of(rest.displacement_gradient(displacements));
}

Matrix3d second_piola_stress(const Matrix3d& strain, const Material& material) {
  return second_piola_stress(strain, material.lame_lambda(), material.lame_mu());
}

Matrix3d first_piola_stress(const Matrix3d& f, const Material& material) {
  if (!is_st_venant_kirchhoff(f, material)) return law_of(material.model).density(f, material, false).first;
  return f * second_piola_stress(strain_of(f - Matrix3d::Identity()), material);
}

double von_mises(const Matrix3d& f, const Material& material) { return von_mises(f, first_piola_stress(f, material)); }

double von_mises(const Matrix3d& f, const Matrix3d& first_piola) {
  // The Cauchy stress of a flattened tet is infinite; the bound keeps it a number that a file can hold.
  const double volume_ratio = std::max(std::abs(f.determinant()), 1e-12);
  const Matrix3d cauchy = first_piola * f.transpose() / volume_ratio;
  const Matrix3d deviator = cauchy - cauchy.trace() / 3 * Matrix3d::Identity();
  return std::sqrt(1.5 * deviator.squaredNorm());
}

void clamp_negative_eigenvalues(Eigen::Ref<Eigen::MatrixXd> hessian) {
  const SymmetricEigen eigen = symmetric_eigen(hessian);
  if (eigen.values[0] >= 0) return;
  const Eigen::VectorXd clamped = eigen.values.cwiseMax(0.0);
  hessian = eigen.vectors * clamped.asDiagonal() * eigen.vectors.transpose();
}

// The viscous part always acts on the Green strain itself, which is smooth for any shape of the tet.
Derivatives elastic(const LinearTet& rest, const Corners& displacements, const Material& material,
                    double full_damping_over_h, const Matrix3d& previous_strain, bool with_hessian, bool project) {
  const double damping_over_h = full_damping_over_h * damping_share(material.model, previous_strain);
  const Matrix3d h = rest.displacement_gradient(displacements);
  const Matrix3d f = Matrix3d::Identity() + h;
  const Matrix3d strain = strain_of(h);
  const Matrix3d strain_change = strain - previous_strain;
  const bool plain = is_st_venant_kirchhoff(f, material);
  // Of the terms with St. Venant-Kirchhoff's stiffness.
  const double elastic_lambda = plain ? material.lame_lambda() : 0, elastic_mu = plain ? material.lame_mu() : 0;
  const double damped_lambda = damping_over_h * viscous_lambda(material),
               damped_mu = damping_over_h * material.lame_mu();
  const Matrix3d stress = second_piola_stress(strain, elastic_lambda, elastic_mu) +
                          second_piola_stress(strain_change, damped_lambda, damped_mu);

  Derivatives result;
  result.energy = rest.volume * (energy_density(strain, elastic_lambda, elastic_mu) +
                                 energy_density(strain_change, damped_lambda, damped_mu));
  const Eigen::Matrix<double, 3, 4> fb = f * rest.gradients;  // F b_a
  Eigen::Map<Eigen::Matrix<double, 3, 4>> gradient(result.gradient.data());
  gradient = rest.volume * (f * stress) * rest.gradients;
  Density density;
  if (!plain) {
    density = law_of(material.model).density(f, material, with_hessian);
    result.energy += rest.volume * density.energy;
    gradient += rest.volume * density.first * rest.gradients;
  }
  if (!with_hessian) return result;

  // Block (a, b) of the second variation of V Psi:
  // V [ (b_a . S b_b) I + lambda (F b_a)(F b_b)^T + mu (b_a . b_b) F F^T + mu (F b_b)(F b_a)^T ]
  const double lambda = rest.volume * (elastic_lambda + damped_lambda);
  const double mu = rest.volume * (elastic_mu + damped_mu);
  const Matrix3d mu_fft = mu * f * f.transpose();
  const Eigen::Matrix4d bb = rest.gradients.transpose() * rest.gradients;
  const Eigen::Matrix4d bsb = rest.volume * rest.gradients.transpose() * stress * rest.gradients;
  for (int a = 0; a < 4; ++a)
    for (int b = a; b < 4; ++b) {
      Matrix3d block = bb(a, b) * mu_fft;
      block.diagonal().array() += bsb(a, b);
      block += fb.col(a) * (lambda * fb.col(b)).transpose() + fb.col(b) * (mu * fb.col(a)).transpose();
      if (!plain)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            block +=
                rest.volume * rest.gradients(k, a) * rest.gradients(l, b) * density.second.block<3, 3>(3 * k, 3 * l);
      result.hessian.block<3, 3>(3 * a, 3 * b) = block;
      if (a != b) result.hessian.block<3, 3>(3 * b, 3 * a) = block.transpose();
    }
  if (project) clamp_negative_eigenvalues(result.hessian);
  return result;
}

}  // namespace fascia::reference
