// Writes changes from sliders back to the scene, so that it can be saved and the provenance of pictures is correct.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// The "materials" of a body, as in a scene file.
struct MaterialEntries {
  Material material;                                                       // "default"
  std::vector<std::pair<std::string, MaterialOverride>> region_materials;  // by key, ascending
  bool operator==(const MaterialEntries&) const = default;
};

/// The entries of every body of the scene, updated to the values of `materials` [model.materials.size()] where they
/// differ.
std::vector<MaterialEntries> material_entries(const Scene& scene, const Model& model,
                                              const std::vector<Material>& materials);

/// Updates the scene's material entries to the values of `materials` [model.materials.size()] where they differ.
void follow_materials(Scene& scene, const Model& model, const std::vector<Material>& materials);
inline void follow_materials(Scene& scene, const Model& model) { follow_materials(scene, model, model.materials); }

}  // namespace fascia
