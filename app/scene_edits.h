// Changes made with sliders, written back into the scene, so that it can be saved and pictures tell the truth about it.
#pragma once
#include <cstddef>

#include "sim/model.h"

namespace fascia {

/// The scene's material entries get the values of `materials` [model.materials.size()], wherever they differ.
void follow_materials(Scene& scene, const Model& model, const std::vector<Material>& materials);
inline void follow_materials(Scene& scene, const Model& model) { follow_materials(scene, model, model.materials); }

}  // namespace fascia
