#include <algorithm>

#include "sim/material/law.h"

namespace fascia {

const std::vector<const MaterialLaw*>& material_laws() {
  static const std::vector<const MaterialLaw*> laws = {
      &kSignedStVenantKirchhoff, &kStVenantKirchhoff, &kStableNeoHookean, &kNeoHookean, &kMooneyRivlin, &kSquared};
  return laws;
}

const MaterialLaw& law_of(MaterialModel model) {
  return **std::find_if(material_laws().begin(), material_laws().end(),
                        [&](const MaterialLaw* law) { return law->model == model; });
}

VolumeSplit volume_split(const Material& material) {
  VolumeSplit split{material, law_of(material.model).averaged_bulk(material)};
  if (split.bulk <= 0) return {material, 0};
  const double lambda = material.lame_lambda() - split.bulk, mu = material.lame_mu();
  split.pointwise.poisson_ratio = lambda / (2 * (lambda + mu));
  split.pointwise.young_modulus = 2 * mu * (1 + split.pointwise.poisson_ratio);
  return split;
}

double damping_share(MaterialModel model, const Eigen::Matrix3d& previous_strain) {
  return law_of(model).fades_damping ? 1 / std::max(1.0, 1 + 2.0 / 3 * previous_strain.trace()) : 1;
}

double viscous_lambda(const Material& material) {
  if (material.poisson_ratio <= kMostViscousRatio) return material.lame_lambda();
  return 2 * kMostViscousRatio / (1 - 2 * kMostViscousRatio) * material.lame_mu();
}

bool reads(MaterialModel model, std::string_view field) {
  return std::all_of(material_laws().begin(), material_laws().end(), [&](const MaterialLaw* law) {
    return law->model == model || !law->own_field || field != law->own_field;
  });
}

const std::vector<MaterialModel>& material_models() {
  static const std::vector<MaterialModel> models = [] {
    std::vector<MaterialModel> list;
    for (const MaterialLaw* law : material_laws()) list.push_back(law->model);
    return list;
  }();
  return models;
}

const char* name_of(MaterialModel model) { return law_of(model).name; }

std::optional<MaterialModel> find_material_model(std::string_view name) {
  for (const MaterialLaw* law : material_laws())
    if (name == law->name) return law->model;
  return std::nullopt;
}

}  // namespace fascia
