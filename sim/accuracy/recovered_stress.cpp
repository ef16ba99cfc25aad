#include "sim/accuracy/recovered_stress.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "sim/material/law.h"
#include "sim/material/signed_svd.h"
#include "sim/material/symmetric_eigen.h"
#include "sim/reference/quadratic_elasticity.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using reference::Vector6d;

// A direction in which the samples determine the polynomial ten thousand times less than in the best one is left flat.
constexpr double kLeastEigenvalue = 1e-4;

template <std::size_t n>
std::array<Vector3d, n> gather(const std::vector<Vector3d>& vectors, const ElementVertices& element) {
  std::array<Vector3d, n> result;
  for (std::size_t a = 0; a < n; ++a) result[a] = vectors[element[a]];
  return result;
}

Vector3d place_of(const Model& model, std::size_t t, const Vector4d& barycentric) {
  Vector3d place = Vector3d::Zero();
  for (int a = 0; a < 4; ++a)
    place += barycentric[a] * model.rest_positions[model.tets[t][static_cast<std::size_t>(a)]];
  return place;
}

std::vector<Vector4d> sample_points(bool quadratic) {
  return quadratic ? QuadraticTet::points() : std::vector<Vector4d>{Vector4d::Constant(0.25)};
}

/// 1, x, y, z, and the products of two coordinates.
Eigen::Matrix<double, 10, 1> terms_at(const Vector3d& x) {
  Eigen::Matrix<double, 10, 1> p;
  p << 1, x, x.cwiseProduct(x), x.y() * x.z(), x.x() * x.z(), x.x() * x.y();
  return p;
}

}  // namespace

Vector6d components_of(const Matrix3d& s) {
  Vector6d result;
  result << s(0, 0), s(1, 1), s(2, 2), 0.5 * (s(1, 2) + s(2, 1)), 0.5 * (s(0, 2) + s(2, 0)), 0.5 * (s(0, 1) + s(1, 0));
  return result;
}

Matrix3d matrix_of(const Vector6d& s) {
  Matrix3d m;
  m << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
  return m;
}

double volume_of(const Model& model, std::size_t t) {
  const auto& x = model.rest_positions;
  const Tet& tet = model.tets[t];
  return signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6;
}

const std::array<VolumePoint, 14>& volume_points() {
  static const std::array<VolumePoint, 14> points = [] {
    std::array<VolumePoint, 14> all;
    std::size_t next = 0;
    for (const auto& [share, weight] : {std::pair(0.31088591926330060980, 0.11268792571801585080),
                                        std::pair(0.09273525031089122640, 0.07349304311636194934)})
      for (int a = 0; a < 4; ++a) {
        all[next] = {Vector4d::Constant(share), weight};
        all[next++].barycentric[a] = 1 - 3 * share;
      }
    constexpr double kShare = 0.04550370412564964949;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) {
        all[next] = {Vector4d::Constant(kShare), 0.04254602077708146644};
        all[next].barycentric[a] = all[next].barycentric[b] = 0.5 - kShare;
        ++next;
      }
    return all;
  }();
  return points;
}

std::vector<PointStress> stresses_of(const Model& model, const State& state, std::size_t t,
                                     const std::vector<Vector4d>& barycentric) {
  const ElementVertices element = model.element(t);
  const Material& material = model.materials[model.tet_material[t]];
  const LinearTet corners(gather<4>(model.rest_positions, element));
  std::vector<PointStress> result;
  const auto add = [&](const Matrix3d& f, const Matrix3d& first_piola, double growth_gap) {
    const SignedSvd svd = signed_svd(f);
    const Matrix3d rotation = svd.u * svd.v.transpose();
    result.push_back({f, rotation, components_of(rotation.transpose() * first_piola), growth_gap});
  };
  if (model.is_quadratic(t)) {
    const QuadraticTet tet(corners);
    const QuadraticTet::Nodes u = gather<10>(state.displacement, element);
    const QuadraticTet::PointGradients at_corners = tet.at_corners(u);
    const std::vector<Matrix3d> first = reference::first_piola_stresses(tet, u, material, barycentric);
    const MaterialLaw& law = law_of(material.model);
    double mean = 0;
    for (const Matrix3d& h : tet.at_points(u))
      mean += law.dilatation(Matrix3d::Identity() + h, false).value / QuadraticTet::kPoints;
    for (std::size_t p = 0; p < first.size(); ++p) {
      Matrix3d f = Matrix3d::Identity();
      for (int a = 0; a < 4; ++a) f += barycentric[p][a] * at_corners[static_cast<std::size_t>(a)];
      add(f, first[p], law.dilatation(f, false).value - mean);
    }
  } else {
    const Matrix3d f = corners.deformation_gradient(gather<4>(state.displacement, element));
    add(f, reference::first_piola_stress(f, material), 0);
    result.resize(barycentric.size(), result.front());
  }
  return result;
}

RecoveredStress::Patch RecoveredStress::fit(const std::vector<Sample>& samples, int most_terms) {
  Patch patch{Vector3d::Zero(), 0, {}};
  double weight = 0, spread = 0;
  for (const Sample& sample : samples) {
    patch.center += sample.weight * sample.place;
    weight += sample.weight;
  }
  patch.center /= weight;
  for (const Sample& sample : samples) spread += sample.weight * (sample.place - patch.center).squaredNorm();
  patch.scale = spread > 0 ? 1 / std::sqrt(spread / weight) : 0;
  // One degree after the other, each to what the lower ones leave: a direction that the samples do not determine then
  // costs nothing of a uniform or linear stress.
  patch.coefficients.setZero();
  for (const int terms : {1, 4, 10}) {
    if (terms > most_terms) break;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(terms, terms), right = Eigen::MatrixXd::Zero(terms, 6);
    for (const Sample& sample : samples) {
      const Eigen::VectorXd p = terms_at(patch.scale * (sample.place - patch.center));
      const Vector6d missing = sample.stress - patch.coefficients.transpose() * p;
      normal += sample.weight / weight * p.head(terms) * p.head(terms).transpose();
      right += sample.weight / weight * p.head(terms) * missing.transpose();
    }
    const SymmetricEigen eigen = symmetric_eigen(normal);
    const Eigen::VectorXd& values = eigen.values;
    Eigen::MatrixXd by_eigenvector = eigen.vectors.transpose() * right;
    for (int k = 0; k < terms; ++k)
      by_eigenvector.row(k) *= values[k] > kLeastEigenvalue * values[terms - 1] ? 1 / values[k] : 0;
    patch.coefficients.topRows(terms) += eigen.vectors * by_eigenvector;
  }
  return patch;
}

RecoveredStress::RecoveredStress(const Model& model, const State& state, const std::stop_token& stop) : model_(model) {
  std::vector<std::vector<Sample>> samples(model.tets.size());
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (stop.stop_requested()) return;
    const std::vector<Vector4d> points = sample_points(model.is_quadratic(t));
    const std::vector<PointStress> stresses = stresses_of(model, state, t, points);
    const double weight = volume_of(model, t) / static_cast<double>(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
      samples[t].push_back({place_of(model, t, points[p]), weight, stresses[p].stress});
  }
  // Patches: the tets of one material around a corner vertex.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  std::vector<std::vector<std::uint32_t>> tets_of;
  patch_of_.resize(model.tets.size());
  for (std::uint32_t t = 0; t < model.tets.size(); ++t)
    for (std::size_t a = 0; a < 4; ++a) {
      const auto [entry, added] = numbers.emplace(std::pair(model.tets[t][a], model.tet_material[t]),
                                                  static_cast<std::uint32_t>(tets_of.size()));
      if (added) tets_of.emplace_back();
      tets_of[entry->second].push_back(t);
      patch_of_[t][a] = entry->second;
    }
  patches_.reserve(tets_of.size());
  for (const std::vector<std::uint32_t>& around : tets_of) {
    if (stop.stop_requested()) return;
    const bool quadratic = std::all_of(around.begin(), around.end(), [&](auto t) { return model.is_quadratic(t); });
    const int terms = quadratic ? 10 : 4;
    std::vector<std::uint32_t> tets = around;
    std::size_t count = 0;
    for (const std::uint32_t t : tets) count += samples[t].size();
    // Too few tets at edges of the body: those around their corners, too.
    if (count < 2 * static_cast<std::size_t>(terms)) {
      for (const std::uint32_t t : around)
        for (const std::uint32_t patch : patch_of_[t])
          tets.insert(tets.end(), tets_of[patch].begin(), tets_of[patch].end());
      std::sort(tets.begin(), tets.end());
      tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
    }
    std::vector<Sample> all;
    for (const std::uint32_t t : tets) all.insert(all.end(), samples[t].begin(), samples[t].end());
    patches_.push_back(fit(all, terms));
  }
}

Vector6d RecoveredStress::at(std::size_t t, const Vector4d& barycentric) const {
  const Vector3d place = place_of(model_, t, barycentric);
  Vector6d sum = Vector6d::Zero();
  for (int a = 0; a < 4; ++a) {
    const Patch& patch = patches_[patch_of_[t][static_cast<std::size_t>(a)]];
    sum += barycentric[a] * patch.coefficients.transpose() * terms_at(patch.scale * (place - patch.center));
  }
  return sum;
}

}  // namespace fascia
