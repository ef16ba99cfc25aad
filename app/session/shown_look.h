// Converts a scene's display settings to the renderer's, and computes the automatic range of a heat map.
#pragma once
#include <optional>

#include "render/view/look.h"
#include "render/view/tissue_paint.h"
#include "sim/gpu/readback/shown_range.h"
#include "sim/material/material.h"
#include "sim/scene/settings/display.h"

namespace fascia {

/// Sets the parts of `look` that the scene's key "display" defines; the range only if it is fixed.
void show(const DisplaySettings& display, Look& look);

/// The paint that a material's look and color define.
TissuePaint paint_of(const Material& material);

/// Updates the `range` of one quantity to the values shown: from 0 to a round number above nearly all of them, or
/// symmetric about the quantity's neutral value. Two percent of the values may lie beyond, since the stress at a single
/// vertex would else leave one color for all others, but none by more than ten times. The range grows at once and
/// shrinks only when most of it is unused, since a flickering bar is unreadable; never with `only_grows`. None until a
/// value other than the neutral one was shown.
void follow_range(const ShownValues& shown, ColorBy color, bool only_grows, std::optional<Eigen::Vector2f>& range);

}  // namespace fascia
