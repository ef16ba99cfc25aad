// From what a scene says about its pictures to what the renderer is told, and the automatic range of a heat map.
#pragma once
#include <optional>

#include "render/view/look.h"
#include "sim/scene/settings/display.h"

namespace fascia {

/// Everything of `look` that the scene's key "display" decides; the range only where it is fixed.
void show(const DisplaySettings& display, Look& look);

/// `range` of one quantity follows the smallest and largest value shown: from 0 to a round number above the largest, or
/// as far to both sides of the quantity's neutral value. It grows at once and shrinks only when most of it is unused: a
/// bar that flickers cannot be read. None until something else than the neutral value was shown.
void follow_range(const Eigen::Vector2d& shown, ColorBy color, std::optional<Eigen::Vector2f>& range);

}  // namespace fascia
