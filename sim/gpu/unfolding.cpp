#include "sim/gpu/unfolding.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kInsideOut = 0.1;      // share of the tets
constexpr double kUnfoldedRatio = 0.3;  // J

// The number of tets with J <= `ratio`.
std::size_t count_below(const Model& model, const State& state, double ratio) {
  const auto volume = [](const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    return (b - a).dot((c - a).cross(d - a));
  };
  const auto& x = model.rest_positions;
  const auto moved = [&](std::uint32_t v) -> Vector3d { return x[v] + state.displacement[v]; };
  return static_cast<std::size_t>(std::count_if(model.tets.begin(), model.tets.end(), [&](const Tet& tet) {
    return volume(moved(tet[0]), moved(tet[1]), moved(tet[2]), moved(tet[3])) <=
           ratio * volume(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]);
  }));
}

// Whether the law has a logarithm of the volume ratio (sim/material/invariants.h).
bool has_logarithm(const Material& material) {
  return material.model == MaterialModel::squared || material.model == MaterialModel::neo_hookean ||
         material.model == MaterialModel::mooney_rivlin;
}

}  // namespace

bool needs_unfolding(const Model& model, const State& state) {
  if (std::none_of(model.materials.begin(), model.materials.end(), has_logarithm)) return false;
  return static_cast<double>(count_below(model, state, 0)) > kInsideOut * static_cast<double>(model.tets.size());
}

bool is_unfolded(const Model& model, const State& state) { return count_below(model, state, kUnfoldedRatio) == 0; }

void take_unfolding_law(std::vector<Material>& materials) {
  for (Material& material : materials)
    if (has_logarithm(material)) material.model = MaterialModel::signed_st_venant_kirchhoff;
}

}  // namespace fascia
