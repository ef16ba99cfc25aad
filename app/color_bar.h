// What the colors mean: the scale of the heat map with its quantity, unit and round ticks, or the names of the regions.
#pragma once
#include "app/session.h"

namespace fascia {

inline bool has_legend(const Session& session) { return session.look.heat_map || session.look.regions; }

/// On a panel at the right edge of the picture, in ImGui's background layer; not in pictures so small that it would hide much of them.
void draw_legend(const Session& session);

}  // namespace fascia
