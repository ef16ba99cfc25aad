#include "sim/accuracy/nodal_stress.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "sim/accuracy/recovered_stress.h"
#include "sim/elements/quadratic_tet.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector4d;
using reference::Vector6d;

constexpr double kLeastRatio = 1e-12;  // of volumes: flat tets alone have a stress that a file can hold
// Each step leaves at most 4/5 of the difference to the fit: M_L^-1 M has no eigenvalues outside of [1/5, 1].
constexpr int kFitSteps = 40;

double von_mises_of(const Vector6d& s) {
  Vector6d deviator = s;
  deviator.head<3>().array() -= s.head<3>().sum() / 3;
  return std::sqrt(1.5 * (deviator.head<3>().squaredNorm() + 2 * deviator.tail<3>().squaredNorm()));
}

/// Barycentric coordinates of the ten vertices of a quadratic tet.
const std::vector<Vector4d>& places_of_ten() {
  static const std::vector<Vector4d> places = [] {
    std::vector<Vector4d> list;
    for (int a = 0; a < 4; ++a) list.push_back(Vector4d::Unit(a));
    for (const auto& [a, b] : kMidEdgeCorners)
      list.push_back(0.5 * (Vector4d::Unit(static_cast<int>(a)) + Vector4d::Unit(static_cast<int>(b))));
    return list;
  }();
  return places;
}

/// The vertices of each material, those of different ones apart.
struct Nodes {
  explicit Nodes(const Model& model) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    for (std::size_t t = 0; t < model.tets.size(); ++t) {
      const ElementVertices element = model.element(t);
      std::array<std::uint32_t, 10> mine{};
      for (std::size_t n = 0; n < element.size(); ++n) {
        const auto [entry, added] =
            numbers.emplace(std::pair(element[n], model.tet_material[t]), static_cast<std::uint32_t>(vertex.size()));
        if (added) vertex.push_back(element[n]);
        mine[n] = entry->second;
      }
      of_tet.push_back(mine);
    }
  }
  std::vector<std::uint32_t> vertex;                  // [node]
  std::vector<std::array<std::uint32_t, 10>> of_tet;  // [tet_count]; four in linear tets
};

/// Fits the stresses of the linear tets, by steps of s += M_L^-1 (f - M s) with the lumped matrix M_L.
void fit_linear(const Model& model, const State& state, const Nodes& nodes, std::vector<Vector6d>& s) {
  std::vector<std::size_t> tets;
  std::vector<double> volumes, lumped(s.size(), 0);
  std::vector<Vector6d> right(s.size(), Vector6d::Zero()), rest;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (model.is_quadratic(t)) continue;
    tets.push_back(t);
    volumes.push_back(volume_of(model, t));
    const PointStress own = stresses_of(model, state, t, {Vector4d::Constant(0.25)}).front();
    const Matrix3d kirchhoff = own.rotation * matrix_of(own.stress) * own.f.transpose();
    const Vector6d stress = components_of(kirchhoff) / std::max(std::abs(own.f.determinant()), kLeastRatio);
    for (std::size_t a = 0; a < 4; ++a) {
      right[nodes.of_tet[t][a]] += volumes.back() / 4 * stress;
      lumped[nodes.of_tet[t][a]] += volumes.back() / 4;
    }
  }
  for (int step = 0; step < kFitSteps; ++step) {
    rest = right;
    for (std::size_t k = 0; k < tets.size(); ++k) {
      const auto& mine = nodes.of_tet[tets[k]];
      const Vector6d sum = s[mine[0]] + s[mine[1]] + s[mine[2]] + s[mine[3]];
      for (std::size_t a = 0; a < 4; ++a) rest[mine[a]] -= volumes[k] / 20 * (sum + s[mine[a]]);
    }
    for (std::size_t n = 0; n < s.size(); ++n)
      if (lumped[n] > 0) s[n] += rest[n] / lumped[n];
  }
}

void evaluate_patches(const Model& model, const State& state, const Nodes& nodes, std::vector<Vector6d>& s,
                      const std::stop_token& stop) {
  const RecoveredStress recovered(model, state, stop);
  if (stop.stop_requested()) return;
  std::vector<double> volume(s.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (!model.is_quadratic(t)) continue;
    const std::vector<PointStress> own = stresses_of(model, state, t, places_of_ten());
    for (std::size_t n = 0; n < own.size(); ++n) {
      const Matrix3d first_piola = own[n].rotation * matrix_of(recovered.at(t, places_of_ten()[n]));
      const std::uint32_t node = nodes.of_tet[t][n];
      s[node] += volume_of(model, t) * components_of(first_piola * own[n].f.transpose());
      volume[node] += volume_of(model, t) * std::max(std::abs(own[n].f.determinant()), kLeastRatio);
    }
  }
  for (std::size_t n = 0; n < s.size(); ++n)
    if (volume[n] > 0) s[n] /= volume[n];
}

}  // namespace

NodalStress nodal_stress(const Model& model, const State& state, const std::stop_token& stop) {
  const std::size_t count = model.rest_positions.size();
  NodalStress result{std::vector<Vector6d>(count, Vector6d::Zero()), std::vector<double>(count, 0)};
  if (stop.stop_requested()) return result;
  const Nodes nodes(model);
  std::vector<Vector6d> stress(nodes.vertex.size(), Vector6d::Zero());
  fit_linear(model, state, nodes, stress);
  if (model.has_quadratic()) evaluate_patches(model, state, nodes, stress, stop);
  if (stop.stop_requested()) return result;
  for (std::size_t n = 0; n < stress.size(); ++n) {
    const std::uint32_t v = nodes.vertex[n];
    const double value = von_mises_of(stress[n]);
    if (value < result.von_mises[v]) continue;
    result.cauchy[v] = stress[n];
    result.von_mises[v] = value;
  }
  return result;
}

std::vector<double> vertex_volumes(const Model& model) {
  std::vector<double> volumes(model.rest_positions.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const ElementVertices element = model.element(t);
    const bool quadratic = model.is_quadratic(t);
    for (std::size_t n = 0; n < element.size(); ++n) {
      const double share = !quadratic ? 0.25 : n < 4 ? QuadraticTet::kCornerMass : QuadraticTet::kMidEdgeMass;
      volumes[element[n]] += share * volume_of(model, t);
    }
  }
  return volumes;
}

double exceeded_by_a_hundredth(const std::vector<double>& values, const std::vector<double>& volumes) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  const double whole = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  double above = 0;
  for (const std::size_t k : order) {
    above += volumes[k];
    if (above >= 0.01 * whole) return values[k];
  }
  return 0;
}

PeakStress peak_of(const NodalStress& stress, const Model& model) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>& values = stress.von_mises;
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    return {kUnknown, kUnknown};
  return {values.empty() ? 0 : *std::max_element(values.begin(), values.end()),
          exceeded_by_a_hundredth(values, vertex_volumes(model))};
}

double stress_of_rounding(const Model& model, const State& state) {
  std::vector<double> stresses, volumes;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    double farthest = 0;
    for (const std::uint32_t v : model.element(t)) farthest = std::max(farthest, state.displacement[v].norm());
    const double volume = volume_of(model, t), edge = std::cbrt(6 * std::sqrt(2.0) * volume);
    stresses.push_back(kDisplacementRounding * farthest / edge * model.materials[model.tet_material[t]].young_modulus);
    volumes.push_back(volume);
  }
  return exceeded_by_a_hundredth(stresses, volumes);
}

double peak_beyond_rounding(const Model& model, const State& state, const std::stop_token& stop) {
  const double peak = peak_of(nodal_stress(model, state, stop), model).p99;
  return peak <= stress_of_rounding(model, state) ? 0 : peak;
}

double peak_distance(const Model& model, const State& state, const State& exact, const std::stop_token& stop) {
  const double truth = peak_beyond_rounding(model, exact, stop);
  return truth > 0 ? std::abs(peak_beyond_rounding(model, state, stop) - truth) / truth : 0;
}

}  // namespace fascia
