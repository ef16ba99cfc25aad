// Changes made with sliders, written back into the scene, so that it can be saved and pictures tell the truth about it.
#pragma once
#include <cstddef>

#include "sim/model.h"

namespace fascia {

/// The scene's material entries get the values of the model's, wherever they differ.
void follow_materials(Scene& scene, const Model& model);

}  // namespace fascia
