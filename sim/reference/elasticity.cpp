#include "sim/reference/elasticity.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// H = F - I from differences of displacements, so that neither the identity nor a common translation costs
// digits.
Matrix3d displacement_gradient(const RestTet& rest, const Corners& u) {
  Matrix3d h = Matrix3d::Zero();
  for (int a = 1; a < 4; ++a) h += (u[a] - u[0]) * rest.gradients.col(a).transpose();
  return h;
}

Matrix3d strain_of(const Matrix3d& h) {
  return 0.5 * (h + h.transpose() + h.transpose() * h);
}

double energy_density(const Matrix3d& strain, const Material& material) {
  const double trace = strain.trace();
  return 0.5 * material.lame_lambda() * trace * trace + material.lame_mu() * strain.squaredNorm();
}

using Matrix9d = Eigen::Matrix<double, 9, 9>;  // column-major components of F

// Energy density, its first and, where wanted, its second derivative by F.
struct Density {
  double energy = 0;
  Matrix3d first = Matrix3d::Zero();
  Matrix9d second = Matrix9d::Zero();
};

Eigen::Map<const Eigen::Matrix<double, 9, 1>> flat(const Matrix3d& m) { return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(m.data()); }

// St. Venant-Kirchhoff of the strains e(s) = (s^2 - 1) / 2 of the signed singular values, and its tangent below kLeastStretch (after
// Irving, Teran, Fedkiw 2004). The second derivative acts on U^T dF V: the diagonal by that of the energy in s, pairs (i, j) by
// (w_i - w_j) / (s_i - s_j) on their symmetric and (w_i + w_j) / (s_i + s_j) on their antisymmetric part, w = dPsi/ds.
Density signed_st_venant_kirchhoff(const Matrix3d& f, const Material& material, bool with_second) {
  const double lambda = material.lame_lambda(), mu = material.lame_mu();
  const SignedSvd svd = signed_svd(f);
  Vector3d e, slope, bend;
  for (int i = 0; i < 3; ++i) {
    const double s = svd.s[i];
    const bool straight = s < kLeastStretch;
    slope[i] = straight ? kLeastStretch : s;
    bend[i] = straight ? 0 : 1;
    e[i] = straight ? 0.5 * (kLeastStretch * kLeastStretch - 1) + kLeastStretch * (s - kLeastStretch) : 0.5 * (s * s - 1);
  }
  const Vector3d stress = lambda * e.sum() * Vector3d::Ones() + 2 * mu * e, w = slope.cwiseProduct(stress);
  Density density;
  density.energy = 0.5 * lambda * e.sum() * e.sum() + mu * e.squaredNorm();
  density.first = svd.u * w.asDiagonal() * svd.v.transpose();
  if (!with_second) return density;
  Matrix3d by_stretch = lambda * slope * slope.transpose();
  by_stretch.diagonal() += 2 * mu * slope.cwiseAbs2() + bend.cwiseProduct(stress);
  const auto mode = [&](int i, int j) -> Matrix3d { return svd.u.col(i) * svd.v.col(j).transpose(); };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      density.second += by_stretch(i, j) * flat(mode(i, i)) * flat(mode(j, j)).transpose();
      if (i >= j) continue;
      const double difference = svd.s[i] - svd.s[j], sum = svd.s[i] + svd.s[j];
      const double symmetric =
          difference > 1e-8 ? (w[i] - w[j]) / difference : by_stretch(i, i) - by_stretch(i, j);
      const double antisymmetric = (w[i] + w[j]) / std::max(sum, 1e-8);
      const Matrix3d even = (mode(i, j) + mode(j, i)) / std::sqrt(2.0), odd = (mode(i, j) - mode(j, i)) / std::sqrt(2.0);
      density.second += symmetric * flat(even) * flat(even).transpose() + antisymmetric * flat(odd) * flat(odd).transpose();
    }
  return density;
}

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Smith, de Goes, Kim 2018, eq. 14, with their Lame parameters (section 3.4), so that small strains see Young's modulus and Poisson's
// ratio: Psi = mu/2 (I - 3) + lambda/2 (J - alpha)^2 - mu/2 log(I + 1), I = |F|^2, less its value at rest.
Density stable_neo_hookean(const Matrix3d& f, const Material& material, bool with_second) {
  const double mu = 4.0 / 3.0 * material.lame_mu(), lambda = material.lame_lambda() + 5.0 / 6.0 * material.lame_mu();
  const double alpha = 1 + 0.75 * mu / lambda;
  const double i = f.squaredNorm(), j = f.determinant();
  Matrix3d cofactor;  // dJ/dF
  cofactor << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
  Density density;
  density.energy = 0.5 * mu * (i - 3) + 0.5 * lambda * ((j - alpha) * (j - alpha) - (1 - alpha) * (1 - alpha)) -
                   0.5 * mu * std::log((i + 1) / 4);
  density.first = mu * (1 - 1 / (i + 1)) * f + lambda * (j - alpha) * cofactor;
  if (!with_second) return density;
  density.second = mu * (1 - 1 / (i + 1)) * Matrix9d::Identity() + 2 * mu / ((i + 1) * (i + 1)) * flat(f) * flat(f).transpose() +
                   lambda * flat(cofactor) * flat(cofactor).transpose();
  for (int k = 0; k < 3; ++k) {  // of J: columns of F against each other
    const Matrix3d cross = lambda * (j - alpha) * cross_matrix(f.col(k));
    const int before = (k + 2) % 3, after = (k + 1) % 3;
    density.second.block<3, 3>(3 * before, 3 * after) += cross;
    density.second.block<3, 3>(3 * after, 3 * before) -= cross;
  }
  return density;
}

// Whether St. Venant-Kirchhoff's own formulas hold: all singular values at least kLeastStretch and none of them negative.
bool upright(const Matrix3d& f) {
  Matrix3d c = f.transpose() * f;
  c.diagonal().array() -= kLeastStretch * kLeastStretch;
  return c(0, 0) > 0 && c(0, 0) * c(1, 1) > c(0, 1) * c(0, 1) && c.determinant() > 0 && f.determinant() > 0;  // Sylvester
}

bool is_st_venant_kirchhoff(const Matrix3d& f, const Material& material) {
  return material.model == MaterialModel::st_venant_kirchhoff ||
         (material.model == MaterialModel::signed_st_venant_kirchhoff && upright(f));
}

Density density_of(const Matrix3d& f, const Material& material, bool with_second) {
  return material.model == MaterialModel::stable_neo_hookean ? stable_neo_hookean(f, material, with_second)
                                                             : signed_st_venant_kirchhoff(f, material, with_second);
}

// The eigenvectors are of run-time size: unrolled at 12 x 12 they take sanitizers minutes to compile.
void clamp_negative_eigenvalues(Matrix12d& hessian) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(hessian);
  if (eigen.eigenvalues()[0] >= 0) return;
  const Eigen::VectorXd clamped = eigen.eigenvalues().cwiseMax(0.0);
  hessian = eigen.eigenvectors() * clamped.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

RestTet::RestTet(const Corners& x) {
  Matrix3d edges;
  edges << x[1] - x[0], x[2] - x[0], x[3] - x[0];
  gradients.rightCols<3>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
  volume = edges.determinant() / 6;
}

Matrix3d deformation_gradient(const RestTet& rest, const Corners& displacements) {
  return Matrix3d::Identity() + displacement_gradient(rest, displacements);
}

Vector6d green_strain(const Matrix3d& f) {
  const Matrix3d strain = strain_of(f - Matrix3d::Identity());
  Vector6d voigt;
  voigt << strain(0, 0), strain(1, 1), strain(2, 2), strain(1, 2), strain(0, 2), strain(0, 1);
  return voigt;
}

Matrix3d green_strain_matrix(const RestTet& rest, const Corners& displacements) {
  return strain_of(displacement_gradient(rest, displacements));
}

Matrix3d second_piola_stress(const Matrix3d& strain, const Material& material) {
  return material.lame_lambda() * strain.trace() * Matrix3d::Identity() + 2 * material.lame_mu() * strain;
}

SignedSvd signed_svd(const Matrix3d& f) {
  const Eigen::JacobiSVD<Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  SignedSvd result{svd.matrixU(), svd.matrixV(), svd.singularValues()};
  for (Matrix3d* m : {&result.u, &result.v})
    if (m->determinant() < 0) {
      m->col(2) *= -1;
      result.s[2] *= -1;
    }
  return result;
}

Matrix3d first_piola_stress(const Matrix3d& f, const Material& material) {
  if (!is_st_venant_kirchhoff(f, material)) return density_of(f, material, false).first;
  return f * second_piola_stress(strain_of(f - Matrix3d::Identity()), material);
}

double von_mises(const Matrix3d& f, const Material& material) {
  // The Cauchy stress of a tet squashed flat is infinite; the bound keeps it a number that a file can hold.
  const double volume_ratio = std::max(std::abs(f.determinant()), 1e-12);
  const Matrix3d cauchy = first_piola_stress(f, material) * f.transpose() / volume_ratio;
  const Matrix3d deviator = cauchy - cauchy.trace() / 3 * Matrix3d::Identity();
  return std::sqrt(1.5 * deviator.squaredNorm());
}

// The viscous part always acts on the Green strain itself: it is smooth, whatever the tet looks like.
Derivatives elastic(const RestTet& rest, const Corners& displacements, const Material& material,
                    double damping_over_h, const Matrix3d& previous_strain, bool with_hessian, bool project) {
  const Matrix3d h = displacement_gradient(rest, displacements);
  const Matrix3d f = Matrix3d::Identity() + h;
  const Matrix3d strain = strain_of(h);
  const Matrix3d strain_change = strain - previous_strain;
  const bool plain = is_st_venant_kirchhoff(f, material);
  const double share = (plain ? 1 : 0) + damping_over_h;  // of what has St. Venant-Kirchhoff's stiffness
  const Matrix3d stress = second_piola_stress((plain ? 1 : 0) * strain + damping_over_h * strain_change, material);

  Derivatives result;
  result.energy = rest.volume * damping_over_h * energy_density(strain_change, material);
  if (plain) result.energy += rest.volume * energy_density(strain, material);
  const Eigen::Matrix<double, 3, 4> fb = f * rest.gradients;  // F b_a
  Eigen::Map<Eigen::Matrix<double, 3, 4>> gradient(result.gradient.data());
  gradient = rest.volume * (f * stress) * rest.gradients;
  Density density;
  if (!plain) {
    density = density_of(f, material, with_hessian);
    result.energy += rest.volume * density.energy;
    gradient += rest.volume * density.first * rest.gradients;
  }
  if (!with_hessian) return result;

  // Block (a, b) of the second variation of V Psi:
  // V [ (b_a . S b_b) I + lambda (F b_a)(F b_b)^T + mu (b_a . b_b) F F^T + mu (F b_b)(F b_a)^T ]
  const double lambda = rest.volume * share * material.lame_lambda();
  const double mu = rest.volume * share * material.lame_mu();
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
            block += rest.volume * rest.gradients(k, a) * rest.gradients(l, b) * density.second.block<3, 3>(3 * k, 3 * l);
      result.hessian.block<3, 3>(3 * a, 3 * b) = block;
      if (a != b) result.hessian.block<3, 3>(3 * b, 3 * a) = block.transpose();
    }
  if (project) clamp_negative_eigenvalues(result.hessian);
  return result;
}

}  // namespace fascia::reference
