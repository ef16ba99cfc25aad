#include "app/bench/box.h"

#include <cmath>

#include "sim/mesh/mesh_generate.h"

namespace fascia {

Model box_model(const Eigen::Vector3i& cells) {
  Model model;
  model.file_mesh = make_box(cells.x(), cells.y(), cells.z(), {1, 0.25, 0.25});
  model.rest_positions = model.file_mesh.positions;
  model.tets = model.file_mesh.tets;
  model.tet_material.assign(model.tets.size(), 0);
  model.materials.resize(1);
  model.materials[0].young_modulus = 1e6;
  model.materials[0].poisson_ratio = 0.3;
  model.initial_velocity.assign(model.rest_positions.size(), Eigen::Vector3d::Zero());
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() == 0) model.fixed.push_back(v);
  return model;
}

Eigen::Vector3i cells_of(std::size_t tets) {
  const int across = std::max(2, static_cast<int>(std::lround(std::cbrt(static_cast<double>(tets) / 24))));
  const int along = std::max(2, static_cast<int>(std::lround(static_cast<double>(tets) / (6.0 * across * across))));
  return {along, across, across};
}

}  // namespace fascia
