// Changes made with sliders, written back into the scene, so that it can be saved and pictures tell the truth about it.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// The "materials" of a body, as a scene file has them.
struct MaterialEntries {
  Material material;                                                       // "default"
  std::vector<std::pair<std::string, MaterialOverride>> region_materials;  // by key, ascending
  bool operator==(const MaterialEntries&) const = default;
};

/// Those of every body of the scene, with the values of `materials` [model.materials.size()], wherever they differ.
std::vector<MaterialEntries> material_entries(const Scene& scene, const Model& model,
                                              const std::vector<Material>& materials);

/// The scene's material entries get the values of `materials` [model.materials.size()], wherever they differ.
void follow_materials(Scene& scene, const Model& model, const std::vector<Material>& materials);
inline void follow_materials(Scene& scene, const Model& model) { follow_materials(scene, model, model.materials); }

}  // namespace fascia
