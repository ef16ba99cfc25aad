#include "sim/accuracy/mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/accuracy/enriched_stress.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/refined_stress.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

using Eigen::Vector4d;
using reference::Vector6d;

double squared_norm(const Vector6d& s) { return s.head<3>().squaredNorm() + 2 * s.tail<3>().squaredNorm(); }

/// D^-1 T, the small strain with stress T.
Vector6d strain_of(const Vector6d& stress, const Material& material) {
  const double lambda = material.lame_lambda(), mu = material.lame_mu();
  Vector6d strain = stress / (2 * mu);
  strain.head<3>().array() -= lambda / (3 * lambda + 2 * mu) * stress.head<3>().sum() / (2 * mu);
  return strain;
}

double von_mises_of(const PointStress& at, const Vector6d& stress) {
  return reference::von_mises(at.f, at.rotation * matrix_of(stress));
}

/// What adds up over the points of a tet, per volume.
struct Densities {
  double squares = 0, work = 0, whole = 0;  // [J/m^3] those of w that are never negative, w, T* : D^-1 T*
};

Densities densities_at(const PointStress& own, const Vector6d& better, const Material& material) {
  const double mu = material.lame_mu(), lambda = material.lame_lambda(), modulus = lambda + 2 * mu / 3,
               bulk = volume_split(material).bulk, gap = own.growth_gap;
  Vector6d deviator = strain_of(better - own.stress, material);
  const double trace = deviator.head<3>().sum();
  deviator.head<3>().array() -= trace / 3;
  const double growth = trace - bulk * gap / modulus;  // theta* - theta
  Densities densities;
  const double squares = 2 * mu * squared_norm(deviator) + (modulus - bulk) * growth * growth;
  densities.squares = squares + bulk * (growth + gap) * (growth + gap);
  densities.work = squares + bulk * (growth * growth - gap * gap);
  const Vector6d whole = strain_of(better, material);
  densities.whole = better.head<3>().dot(whole.head<3>()) + 2 * better.tail<3>().dot(whole.tail<3>());
  return densities;
}

/// Twice the energy of quadratic tets with stress T, whose change of volume is off its mean by `gap`.
double energy_of(const Vector6d& stress, double gap, const Material& material) {
  const double bulk = volume_split(material).bulk;
  Vector6d pointwise = stress;
  pointwise.head<3>().array() += bulk * gap;
  const Vector6d strain = strain_of(pointwise, material);
  return pointwise.head<3>().dot(strain.head<3>()) + 2 * pointwise.tail<3>().dot(strain.tail<3>()) - bulk * gap * gap;
}

Densities densities_at(const PointStress& own, const RefinedStress::Point& finer, const Material& material) {
  const Vector6d lack = finer.stress - own.stress, strain = strain_of(lack, material);
  Densities densities;
  densities.squares = lack.head<3>().dot(strain.head<3>()) + 2 * lack.tail<3>().dot(strain.tail<3>());
  densities.whole = energy_of(finer.stress, finer.growth_gap, material);
  densities.work = densities.whole - energy_of(own.stress, own.growth_gap, material);
  return densities;
}

/// T* of each tet by the best of the three that there is.
class BetterStress {
 public:
  BetterStress(const Model& model, const State& state, const std::stop_token& stop) : model_(model), state_(state) {
    std::array<std::size_t, 2> counts{};  // linear, quadratic
    for (std::size_t t = 0; t < model.tets.size(); ++t) ++counts[model.is_quadratic(t) ? 1 : 0];
    if (counts[0] > 0 && counts[0] <= EnrichedStress::kMostTets) enriched_.emplace(model, state, stop);
    if (enriched_ && !enriched_->converged()) enriched_.reset();
    if (counts[1] > 0 && counts[1] <= RefinedStress::kMostTets) refined_.emplace(model, state, stop);
    if (refined_ && !refined_->converged()) refined_.reset();
    if ((counts[0] > 0 && !enriched_) || (counts[1] > 0 && !refined_)) recovered_.emplace(model, state, stop);
  }

  struct Point {
    double weight;  // share of the volume
    PointStress own;
    Vector6d stress;  // T*
    Densities densities;
  };
  std::vector<Point> at(std::size_t t) const {
    return refined_ && model_.is_quadratic(t) ? of_finer_tets(t) : of_whole(t);
  }

 private:
  std::vector<Point> of_finer_tets(std::size_t t) const {
    const auto finer = refined_->at(t);
    std::vector<Vector4d> places;
    for (const RefinedStress::Point& point : finer) places.push_back(point.barycentric);
    const std::vector<PointStress> own = stresses_of(model_, state_, t, places);
    std::vector<Point> points;
    for (std::size_t p = 0; p < own.size(); ++p)
      points.push_back({1.0 / RefinedStress::kPoints, own[p], finer[p].stress,
                        densities_at(own[p], finer[p], model_.materials[model_.tet_material[t]])});
    return points;
  }

  std::vector<Point> of_whole(std::size_t t) const {
    std::vector<Vector4d> places;
    for (const VolumePoint& point : volume_points()) places.push_back(point.barycentric);
    const std::vector<PointStress> own = stresses_of(model_, state_, t, places);
    std::vector<Point> points;
    for (std::size_t p = 0; p < own.size(); ++p) {
      const Vector6d star = enriched_ && !model_.is_quadratic(t) ? Vector6d(own[p].stress + enriched_->at(t, places[p]))
                                                                 : recovered_->at(t, places[p]);
      points.push_back({volume_points()[p].weight, own[p], star,
                        densities_at(own[p], star, model_.materials[model_.tet_material[t]])});
    }
    return points;
  }

  const Model& model_;
  const State& state_;
  std::optional<EnrichedStress> enriched_;
  std::optional<RefinedStress> refined_;
  std::optional<RecoveredStress> recovered_;
};

}  // namespace

MeshError estimate_mesh_error(const Model& model, const State& state, const std::stop_token& stop) {
  MeshError result;
  result.tets.assign(model.tets.size(), 0);
  const BetterStress found(model, state, stop);
  std::vector<double> squares;               // [tet_count] mean [J/m^3]
  std::vector<double> own, better, volumes;  // [point of a tet]
  double work = 0, whole = 0, all = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (stop.stop_requested()) return result;
    const double volume = volume_of(model, t);
    squares.push_back(0);
    all += volume;
    for (const BetterStress::Point& point : found.at(t)) {
      const double weight = point.weight * volume;
      squares.back() += point.weight * point.densities.squares;
      work += weight * point.densities.work;
      whole += weight * point.densities.whole;
      own.push_back(von_mises_of(point.own, point.own.stress));
      better.push_back(von_mises_of(point.own, point.stress));
      volumes.push_back(weight);
    }
  }
  if (!(whole > 0)) return result;
  result.displacement = std::abs(work) / whole;
  std::transform(squares.begin(), squares.end(), result.tets.begin(),
                 [&](double mean) { return static_cast<float>(std::sqrt(mean / (whole / all))); });
  result.peak = exceeded_by_a_hundredth(better, volumes);
  result.peak_of_tets = exceeded_by_a_hundredth(own, volumes);
  if (result.peak > 0) result.peak_stress = std::abs(1 - result.peak_of_tets / result.peak);
  return result;
}

std::vector<float> at_vertices(const Model& model, const MeshError& error) {
  const std::size_t count = model.rest_positions.size();
  std::vector<double> sum(count, 0), around(count, 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const double volume = volume_of(model, t);
    const ElementVertices element = model.element(t);
    for (const std::uint32_t v : element) {
      sum[v] += volume * static_cast<double>(error.tets[t]);
      around[v] += volume;
    }
  }
  std::vector<float> mean(count, 0);
  for (std::size_t v = 0; v < count; ++v)
    if (around[v] > 0) mean[v] = static_cast<float>(sum[v] / around[v]);
  return mean;
}

}  // namespace fascia
