// Multiplies the lengths of a scene's tools, when the scene gets another unit.
#pragma once
#include "sim/scene/tools/scene_tools.h"

namespace fascia {

void scale_lengths(SceneTools& tools, double factor);

}  // namespace fascia
