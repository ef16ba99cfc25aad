// The legend of the colors in a picture: the scale of the heat map with its quantity, unit and round ticks, or the
// names of the regions. Scene key "display.legend" places it.
#pragma once
#include <optional>

#include "app/overlay/grab_marks.h"
#include "app/session/framing.h"
#include "app/session/session.h"

namespace fascia {

inline bool has_legend(const Session& session) {
  return (session.look.heat_map || session.look.regions) && session.display().legend.side != LegendSide::off;
}

/// The box in which draw_legend() draws in a picture whose first `left` columns are covered; its left and top are 0 or
/// more. None: no legend.
std::optional<Box> legend_box(const Box& picture, const Session& session, float left = 0);
/// What the legend and `panels` pixels of panels at the left cover of a picture [pixels]; a list's unit has `scale` of
/// them.
Margins legend_margins(const Session& session, int width, int height, float scale, double panels);

/// Draws halfway up at an edge of the picture, unless the picture is so small that the legend would hide much of it.
/// Call between ImGui::NewFrame and the next one.
void draw_legend(const MarkArea& area, const Session& session, float left = 0);

}  // namespace fascia
