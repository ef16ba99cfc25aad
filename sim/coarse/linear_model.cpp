#include "sim/coarse/linear_model.h"

#include "shaders/shared/relaxed_bulk.h"
#include "sim/material/law.h"
#include "sim/mesh/linear_tets.h"

namespace fascia {

namespace {

double relaxed_bulk(const Material& material) { return RELAXED_BULK * material.lame_mu(); }

Material with_relaxed_bulk(Material material) {
  const double excess = volume_split(material).bulk - relaxed_bulk(material), mu = material.lame_mu();
  if (excess <= 0) return material;
  const double lambda = material.lame_lambda() - excess;
  material.poisson_ratio = lambda / (2 * (lambda + mu));
  material.young_modulus = 2 * mu * (1 + material.poisson_ratio);
  return material;
}

}  // namespace

bool has_large_bulk(const Model& model) {
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Material& material = model.materials[model.tet_material[t]];
    if (model.is_quadratic(t) && volume_split(material).bulk > relaxed_bulk(material)) return true;
  }
  return false;
}

Model linear_model(const Model& model, bool relaxed) {
  Model linear;
  linear.rest_positions = model.rest_positions;
  linear.materials = model.materials;
  linear.fixed = model.fixed;
  linear.motions = model.motions;
  LinearTets tets = linear_tets(model.tets, model.mid_edges, model.rest_positions, 0, model.tets.size());
  const auto relaxed_from = static_cast<std::uint32_t>(model.materials.size());
  if (relaxed)
    for (const Material& material : model.materials) linear.materials.push_back(with_relaxed_bulk(material));
  for (const std::uint32_t t : tets.source)
    linear.tet_material.push_back(model.tet_material[t] + (relaxed && model.is_quadratic(t) ? relaxed_from : 0));
  linear.tets = std::move(tets.tets);
  return linear;
}

}  // namespace fascia
