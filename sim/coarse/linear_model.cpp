#include "sim/coarse/linear_model.h"

#include "sim/mesh/linear_tets.h"

namespace fascia {

Model linear_model(const Model& model) {
  Model linear;
  linear.rest_positions = model.rest_positions;
  linear.materials = model.materials;
  linear.fixed = model.fixed;
  linear.motions = model.motions;
  LinearTets tets = linear_tets(model.tets, model.mid_edges, model.rest_positions, 0, model.tets.size());
  for (const std::uint32_t t : tets.source) linear.tet_material.push_back(model.tet_material[t]);
  linear.tets = std::move(tets.tets);
  return linear;
}

}  // namespace fascia
