// The legend of the colors: the scale of the heat map with its quantity, unit and round ticks, or the names of the
// regions.
#pragma once
#include <optional>

#include "app/overlay/grab_marks.h"
#include "app/session/session.h"

namespace fascia {

/// The box in which draw_legend() draws in a picture; its left and top are 0 or more. None: no legend.
std::optional<Box> legend_box(const Box& picture, const Session& session);
/// The width that the legend occupies in a picture, in pixels; a list's unit has `scale` of them.
double legend_space(const Session& session, int width, int height, float scale);
inline bool has_legend(const Session& session) { return session.look.heat_map || session.look.regions; }

/// Draws on a plate at the right edge of the picture, unless the picture is so small that the plate would hide much of
/// it. Call between ImGui::NewFrame and the next one.
void draw_legend(const MarkArea& area, const Session& session);

}  // namespace fascia
