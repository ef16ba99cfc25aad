// Converts a scene's display settings to the renderer's, and computes the automatic range of a heat map.
#pragma once
#include <optional>

#include "render/view/look.h"
#include "sim/scene/settings/display.h"

namespace fascia {

/// Sets the parts of `look` that the scene's key "display" defines; the range only if it is fixed.
void show(const DisplaySettings& display, Look& look);

/// Updates the `range` of one quantity to the smallest and largest value shown: from 0 to a round number above the
/// largest, or symmetric about the quantity's neutral value. It grows at once and shrinks only when most of it is
/// unused, since a flickering bar is unreadable. None until a value other than the neutral one was shown.
void follow_range(const Eigen::Vector2d& shown, ColorBy color, std::optional<Eigen::Vector2f>& range);

}  // namespace fascia
