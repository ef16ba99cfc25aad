// The values of materials that a fit may find, for a list to choose from.
#pragma once
#include <string>
#include <vector>

#include "sim/model/model.h"
#include "sim/scene/scene.h"

namespace fascia {

struct FreeValue {
  std::string key;       // as for --free
  std::string field;     // "young_modulus"
  std::string material;  // Model::material_names: "liver: default"
  std::string unit;
};

/// Of every material, in the order of Model::materials; without those of regions that no key names.
std::vector<FreeValue> free_values(const Scene& scene, const Model& model);

}  // namespace fascia
