// What the colors mean: the scale of the heat map with its quantity, unit and round ticks, or the names of the regions.
#pragma once
#include <optional>

#include "app/overlay/grab_marks.h"
#include "app/session/session.h"

namespace fascia {

/// Where draw_legend() draws it in a picture; its left and top are 0 or more. None: it has none.
std::optional<Box> legend_box(const Box& picture, const Session& session);
/// What it takes of the width of a picture, in pixels of which a unit of lists has `scale`.
double legend_space(const Session& session, int width, int height, float scale);
inline bool has_legend(const Session& session) { return session.look.heat_map || session.look.regions; }

/// On a plate at the right edge of the picture; not in pictures so small that it would hide much of them. Between
/// ImGui::NewFrame and the next one.
void draw_legend(const MarkArea& area, const Session& session);

}  // namespace fascia
