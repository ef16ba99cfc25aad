#include "sim/material/material.h"

namespace fascia {

const std::vector<MaterialModel>& material_models() {
  static const std::vector<MaterialModel> models = {MaterialModel::signed_st_venant_kirchhoff, MaterialModel::st_venant_kirchhoff,
                                                    MaterialModel::stable_neo_hookean};
  return models;
}

const char* name_of(MaterialModel model) {
  switch (model) {
    case MaterialModel::signed_st_venant_kirchhoff:
      return "signed_st_venant_kirchhoff";
    case MaterialModel::st_venant_kirchhoff:
      return "st_venant_kirchhoff";
    case MaterialModel::stable_neo_hookean:
      return "stable_neo_hookean";
  }
  return "";
}

std::optional<MaterialModel> find_material_model(std::string_view name) {
  for (const MaterialModel model : material_models()) {
    if (name == name_of(model)) return model;
  }
  return std::nullopt;
}

}  // namespace fascia
