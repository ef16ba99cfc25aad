#include "sim/reference/quadratic_elasticity.h"

#include <Eigen/LU>
#include <algorithm>

#include "sim/material/law.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;

constexpr int kNodes = QuadraticTet::kNodes, kPoints = QuadraticTet::kPoints;

/// Adds the derivatives by F of an energy lambda/2 tr(E)^2 + mu E:E of a strain E whose change is that of the Green
/// strain.
void add_strain_energy(const Matrix3d& f, const Matrix3d& strain, double lambda, double mu, bool with_second,
                       Density& density) {
  const Matrix3d stress = lambda * strain.trace() * Matrix3d::Identity() + 2 * mu * strain;
  density.energy += 0.5 * stress.cwiseProduct(strain).sum();
  density.first += f * stress;
  if (!with_second) return;
  for (int k = 0; k < 9; ++k) {
    Matrix3d e = Matrix3d::Zero();
    e(k % 3, k / 3) = 1;
    const Matrix3d product = f.transpose() * e, change = 0.5 * (product + product.transpose());
    const Matrix3d column = e * stress + f * (lambda * change.trace() * Matrix3d::Identity() + 2 * mu * change);
    density.second.col(k) += fascia::flat(column);
  }
}

Dilatation strain_trace(const Matrix3d& f, const Matrix3d& strain) { return {strain.trace(), f, Matrix9d::Identity()}; }

/// The split law at one point.
struct PointLaw {
  Density density;
  Dilatation dilatation;
};

PointLaw evaluate(const Matrix3d& h, const VolumeSplit& split, bool with_second) {
  const MaterialLaw& law = law_of(split.pointwise.model);
  const Matrix3d f = Matrix3d::Identity() + h;
  if (!law.is_st_venant_kirchhoff || !law.is_st_venant_kirchhoff(f))
    return {law.density(f, split.pointwise, with_second), law.dilatation(f, with_second)};
  const Matrix3d strain = strain_of(h);
  PointLaw point{{}, strain_trace(f, strain)};
  add_strain_energy(f, strain, split.pointwise.lame_lambda(), split.pointwise.lame_mu(), with_second, point.density);
  return point;
}

/// K/2 (mean theta)^2 of a property of the points.
struct AveragedTerm {
  double bulk = 0;  // K [Pa]
  std::array<Dilatation, kPoints> points;

  double mean() const {
    double sum = 0;
    for (const Dilatation& point : points) sum += point.value;
    return sum / kPoints;
  }
};

using Result = ElementDerivatives<kNodes>;
using NodeVectors = Eigen::Matrix<double, 3, kNodes>;

/// Adds weight * grad N_a . second . grad N_b to every block.
void add_hessian(const QuadraticTet::ShapeGradients& shape, const Matrix9d& second, double weight, Result& result) {
  for (int b = 0; b < kNodes; ++b) {
    Eigen::Matrix<double, 9, 3> by_b = Eigen::Matrix<double, 9, 3>::Zero();
    for (int l = 0; l < 3; ++l) by_b += weight * shape(l, b) * second.middleCols<3>(3 * l);
    for (int a = 0; a < kNodes; ++a)
      for (int k = 0; k < 3; ++k) result.hessian.block<3, 3>(3 * a, 3 * b) += shape(k, a) * by_b.middleRows<3>(3 * k);
  }
}

}  // namespace

PointStrains no_strains() {
  PointStrains zeros;
  zeros.fill(Matrix3d::Zero());
  return zeros;
}

PointStrains green_strains(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements) {
  PointStrains strains = rest.at_points(displacements);
  for (Matrix3d& at : strains) at = strain_of(at);
  return strains;
}

Result elastic(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements, const Material& material,
               double full_damping_over_h, const PointStrains& previous, bool with_hessian, bool project) {
  const double damping_over_h =
      full_damping_over_h *
      damping_share(material.model, 0.25 * (previous[0] + previous[1] + previous[2] + previous[3]));
  const VolumeSplit split = volume_split(material);
  const QuadraticTet::PointGradients h = rest.at_points(displacements);
  AveragedTerm elastic{split.bulk, {}}, viscous{damping_over_h * std::max(viscous_lambda(material), 0.0), {}};
  std::array<Density, kPoints> densities;
  Result result;
  for (int q = 0; q < kPoints; ++q) {
    const PointLaw point = evaluate(h[q], split, with_hessian);
    densities[q] = point.density;
    elastic.points[q] = point.dilatation;
    if (damping_over_h > 0) {
      const Matrix3d f = Matrix3d::Identity() + h[q], change = strain_of(h[q]) - previous[q];
      add_strain_energy(f, change, damping_over_h * std::min(material.lame_lambda(), 0.0),
                        damping_over_h * material.lame_mu(), with_hessian, densities[q]);
      viscous.points[q] = strain_trace(f, change);
    }
    result.energy += 0.25 * rest.volume * densities[q].energy;
  }
  for (const AveragedTerm* term : {&elastic, &viscous}) {
    const double mean = term->mean(), pressure = term->bulk * mean;
    result.energy += 0.5 * rest.volume * pressure * mean;
    for (int q = 0; q < kPoints; ++q) {
      densities[q].first += pressure * term->points[q].first;
      if (with_hessian) densities[q].second += pressure * term->points[q].second;
    }
  }

  Eigen::Map<NodeVectors> gradient(result.gradient.data());
  gradient.setZero();
  if (with_hessian) result.hessian.setZero();
  const double weight = 0.25 * rest.volume;
  std::array<NodeVectors, 2> slopes{NodeVectors::Zero(), NodeVectors::Zero()};  // w of both averages
  for (int q = 0; q < kPoints; ++q) {
    const QuadraticTet::ShapeGradients shape = rest.shape_gradients_at_point(q);
    gradient += weight * densities[q].first * shape;
    if (!with_hessian) continue;
    add_hessian(shape, densities[q].second, weight, result);
    slopes[0] += 0.25 * elastic.points[q].first * shape;
    slopes[1] += 0.25 * viscous.points[q].first * shape;
  }
  if (!with_hessian) return result;
  const auto add_square = [&](const NodeVectors& slope, double bulk) {
    const Eigen::Map<const Eigen::Matrix<double, 3 * kNodes, 1>> w(slope.data());
    for (int i = 0; i < 3 * kNodes; ++i) result.hessian.col(i) += rest.volume * bulk * w[i] * w;
  };
  add_square(slopes[0], elastic.bulk);
  if (viscous.bulk > 0) add_square(slopes[1], viscous.bulk);
  if (project) clamp_negative_eigenvalues(result.hessian);
  return result;
}

std::vector<Matrix3d> first_piola_stresses(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements,
                                           const Material& material, const std::vector<Eigen::Vector4d>& barycentric) {
  const VolumeSplit split = volume_split(material);
  AveragedTerm average{split.bulk, {}};
  const QuadraticTet::PointGradients h = rest.at_points(displacements), at_corners = rest.at_corners(displacements);
  for (int q = 0; q < kPoints; ++q) average.points[q] = evaluate(h[q], split, false).dilatation;
  const double pressure = split.bulk * average.mean();
  std::vector<Matrix3d> stresses;
  for (const Eigen::Vector4d& l : barycentric) {
    const Matrix3d there = l[0] * at_corners[0] + l[1] * at_corners[1] + l[2] * at_corners[2] + l[3] * at_corners[3];
    const PointLaw point = evaluate(there, split, false);
    stresses.emplace_back(point.density.first + pressure * point.dilatation.first);
  }
  return stresses;
}

Matrix3d first_piola_stress(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements,
                            const Material& material) {
  return first_piola_stresses(rest, displacements, material, {Eigen::Vector4d::Constant(0.25)}).front();
}

VolumeRatios volume_ratios(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements, bool with_corners) {
  VolumeRatios ratios{1e300, -1e300};
  const auto add = [&](const QuadraticTet::PointGradients& gradients) {
    for (const Matrix3d& h : gradients) {
      const double j = (Matrix3d::Identity() + h).determinant();
      ratios = {std::min(ratios.min, j), std::max(ratios.max, j)};
    }
  };
  add(rest.at_points(displacements));
  if (with_corners) add(rest.at_corners(displacements));
  return ratios;
}

}  // namespace fascia::reference
