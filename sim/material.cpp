#include "sim/material.h"

namespace fascia {

const std::vector<MaterialModel>& material_models() {
  static const std::vector<MaterialModel> models = {MaterialModel::st_venant_kirchhoff};
  return models;
}

const char* name_of(MaterialModel model) {
  switch (model) {
    case MaterialModel::st_venant_kirchhoff:
      return "st_venant_kirchhoff";
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
