#include "sim/accuracy/mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/accuracy/finer_solution.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/rigid_motions.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
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

Densities densities_at(const PointStress& own, const FinerSolution::Point& finer, const Material& material) {
  const Vector6d lack = finer.stress - own.stress, strain = strain_of(lack, material);
  Densities densities;
  densities.squares = lack.head<3>().dot(strain.head<3>()) + 2 * lack.tail<3>().dot(strain.tail<3>());
  densities.whole = energy_of(finer.stress, finer.growth_gap, material);
  densities.work = densities.whole - energy_of(own.stress, own.growth_gap, material);
  return densities;
}

/// T* of each tet, of a finer solution where there is one.
class BetterStress {
 public:
  BetterStress(const Model& model, const State& state, const std::stop_token& stop) : model_(model), state_(state) {
    bool all = true;
    for (const ElementOrder kind : {ElementOrder::linear, ElementOrder::quadratic}) {
      std::size_t count = 0;
      for (std::size_t t = 0; t < model.tets.size(); ++t) count += model.is_quadratic(t) == is_quadratic(kind) ? 1 : 0;
      if (count == 0) continue;
      std::optional<FinerSolution>& finer = finer_[is_quadratic(kind) ? 1 : 0];
      if (count <= FinerSolution::most_tets(kind)) finer.emplace(model, state, kind, stop);
      if (finer && !finer->converged()) finer.reset();
      all = all && finer;
    }
    if (!all) recovered_.emplace(model, state, stop);
  }

  struct Point {
    double weight;  // share of the volume
    PointStress own;
    Vector6d stress;  // T*
    Densities densities;
  };
  std::vector<Point> at(std::size_t t) const {
    const std::optional<FinerSolution>& finer = finer_[model_.is_quadratic(t) ? 1 : 0];
    return finer ? of_finer(*finer, t) : of_patches(t);
  }

  bool has_finer() const { return !recovered_; }

  /// Displacements of the finer solutions [m]; empty without one of them.
  std::vector<Vector3d> displacements() const {
    if (!has_finer()) return {};
    std::vector<Vector3d> result = state_.displacement;
    for (const std::optional<FinerSolution>& finer : finer_) {
      if (!finer) continue;
      const std::vector<Vector3d> moved = finer->displacements();
      // Those of tets of the other kind are the state's.
      for (std::size_t v = 0; v < result.size(); ++v) result[v] += moved[v] - state_.displacement[v];
    }
    return result;
  }

 private:
  static bool is_quadratic(ElementOrder kind) { return kind == ElementOrder::quadratic; }

  std::vector<Point> of_finer(const FinerSolution& solution, std::size_t t) const {
    const std::vector<FinerSolution::Point> finer = solution.at(t);
    std::vector<Vector4d> places;
    for (const FinerSolution::Point& point : finer) places.push_back(point.barycentric);
    const std::vector<PointStress> own = stresses_of(model_, state_, t, places);
    std::vector<Point> points;
    for (std::size_t p = 0; p < own.size(); ++p)
      points.push_back({1.0 / static_cast<double>(own.size()), own[p], finer[p].stress,
                        densities_at(own[p], finer[p], model_.materials[model_.tet_material[t]])});
    return points;
  }

  std::vector<Point> of_patches(std::size_t t) const {
    std::vector<Vector4d> places;
    for (const VolumePoint& point : volume_points()) places.push_back(point.barycentric);
    const std::vector<PointStress> own = stresses_of(model_, state_, t, places);
    std::vector<Point> points;
    for (std::size_t p = 0; p < own.size(); ++p) {
      const Vector6d star = recovered_->at(t, places[p]);
      points.push_back({volume_points()[p].weight, own[p], star,
                        densities_at(own[p], star, model_.materials[model_.tet_material[t]])});
    }
    return points;
  }

  const Model& model_;
  const State& state_;
  std::array<std::optional<FinerSolution>, 2> finer_;  // of linear and of quadratic tets
  std::optional<RecoveredStress> recovered_;
};

/// Of the displacements to better ones, over these; of pieces that nothing holds, over what they are deformed by.
double relative_error(const Model& model, const State& state, const std::vector<Vector3d>& better) {
  std::vector<double> volumes(better.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.tets[t]) volumes[v] += volume_of(model, t) / 4;
  std::vector<Vector3d> whole = better;
  for (const std::vector<std::uint32_t>& piece : free_pieces(model.tets, model.held())) {
    std::vector<Vector3d> rest, now;
    for (const std::uint32_t v : piece) {
      rest.push_back(model.rest_positions[v]);
      now.push_back(rest.back() + better[v]);
    }
    const std::vector<Vector3d> left = deformation(rest, now);
    for (std::size_t k = 0; k < piece.size(); ++k) whole[piece[k]] = left[k];
  }
  double distance = 0, size = 0, moved = 0;
  for (std::size_t v = 0; v < better.size(); ++v) {
    distance += volumes[v] * (better[v] - state.displacement[v]).squaredNorm();
    size += volumes[v] * whole[v].squaredNorm();
    moved += volumes[v] * state.displacement[v].squaredNorm();
  }
  // A body that falls freely is deformed by rounding alone.
  return distance > 0 && size > kDisplacementRounding * kDisplacementRounding * moved ? std::sqrt(distance / size) : 0;
}

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
  if (const std::vector<Vector3d> moved = found.displacements(); !moved.empty())
    result.displacement = relative_error(model, state, moved);
  std::transform(squares.begin(), squares.end(), result.tets.begin(),
                 [&](double mean) { return static_cast<float>(std::sqrt(mean / (whole / all))); });
  result.peak = exceeded_by_a_hundredth(better, volumes);
  result.peak_of_tets = exceeded_by_a_hundredth(own, volumes);
  // T* of patches is what the stress of quadratic tets is recovered from: beside itself it has no error.
  const double told = found.has_finer() ? peak_of(nodal_stress(model, state, stop), model).p99 : result.peak_of_tets;
  if (result.peak > stress_of_rounding(model, state)) result.peak_stress = std::abs(1 - told / result.peak);
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
