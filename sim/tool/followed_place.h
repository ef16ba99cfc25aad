// How a tool follows the place that a hand commands. The hand may jump; the tool must neither pass through tissue nor
// tear it: near tissue no point of it moves by more than a quarter of its finest radius in a step, and where it comes
// from afar it stops before the first touch.
#pragma once
#include <functional>

#include "sim/tool/tool.h"

namespace fascia {

/// The distance of a tool at a place from tissue [m], or less.
using Clearance = std::function<double(const ToolPlace&)>;

/// The finest radius of a tool [m], which is as good as that of a larger one beyond a tenth of the size of the tissue.
double followed_radius(const Tool& tool, double tissue_size);
/// The way [m] of its farthest point from one place to the other, or more: moved, turned, and its jaws closed.
double way_between(const Tool& tool, const ToolPlace& from, const ToolPlace& to, double tissue_size);
/// Its place at the end of a step that begins with it at `now`.
ToolPlace followed_place(const Tool& tool, const ToolPlace& now, const ToolPlace& commanded, double tissue_size,
                         const Clearance& clearance);

}  // namespace fascia
