#include "sim/accuracy/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/accuracy/enriched_stress.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

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

Densities densities_at(const PointStress& own, const Vector6d& recovered, const Material& material) {
  const double mu = material.lame_mu(), lambda = material.lame_lambda(), gap = own.growth_gap;
  Vector6d deviator = strain_of(recovered - own.stress, material);
  const double trace = deviator.head<3>().sum();
  deviator.head<3>().array() -= trace / 3;
  const double growth = trace + 2 * mu * gap / (3 * lambda + 2 * mu);  // tr eps* - mean theta
  Densities densities;
  densities.squares =
      2 * mu * (squared_norm(deviator) + (growth - gap) * (growth - gap) / 3) + lambda * growth * growth;
  densities.work = densities.squares - 2 * lambda * growth * gap;
  const Vector6d whole = strain_of(recovered, material);
  densities.whole = recovered.head<3>().dot(whole.head<3>()) + 2 * recovered.tail<3>().dot(whole.tail<3>());
  return densities;
}

}  // namespace

MeshError estimate_mesh_error(const Model& model, const State& state, const std::stop_token& stop) {
  MeshError result;
  result.tets.assign(model.tets.size(), 0);
  const auto linear = static_cast<std::size_t>(
      std::count_if(model.tets.begin(), model.tets.end(),
                    [&, t = std::size_t{0}](const Tet&) mutable { return !model.is_quadratic(t++); }));
  std::optional<EnrichedStress> enriched;
  std::optional<RecoveredStress> recovered;
  if (linear > 0 && linear <= EnrichedStress::kMostTets) enriched.emplace(model, state, stop);
  if (enriched && !enriched->converged()) enriched.reset();
  if (!enriched || linear < model.tets.size()) recovered.emplace(model, state, stop);
  std::vector<Eigen::Vector4d> points;
  for (const VolumePoint& point : volume_points()) points.push_back(point.barycentric);
  std::vector<double> squares;               // [tet_count] mean [J/m^3]
  std::vector<double> own, better, volumes;  // [point of a tet]
  double work = 0, whole = 0, all = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (stop.stop_requested()) return result;
    const Material& material = model.materials[model.tet_material[t]];
    const double volume = volume_of(model, t);
    const std::vector<PointStress> stresses = stresses_of(model, state, t, points);
    squares.push_back(0);
    all += volume;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double share = volume_points()[p].weight, weight = share * volume;
      const Vector6d star = enriched && !model.is_quadratic(t)
                                ? Vector6d(stresses[p].stress + enriched->at(t, points[p]))
                                : recovered->at(t, points[p]);
      const Densities densities = densities_at(stresses[p], star, material);
      squares.back() += share * densities.squares;
      work += weight * densities.work;
      whole += weight * densities.whole;
      own.push_back(von_mises_of(stresses[p], stresses[p].stress));
      better.push_back(von_mises_of(stresses[p], star));
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
