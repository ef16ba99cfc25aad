// The motion of a scene's tools within a step.
#pragma once
#include <vector>

#include "sim/tool/tool.h"

namespace fascia {

/// On the way from one place of a tool to another, jaws included.
ToolPlace between(const ToolPlace& from, const ToolPlace& to, double share);

struct ToolMotion {
  std::vector<ToolPlace> from, to;  // [tool] at the start and at the end
  /// The motion between two shares of this one, straight.
  ToolMotion part(double from_share, double to_share) const;
  bool operator==(const ToolMotion&) const = default;
};

/// As the paths of the tools state it [s].
ToolMotion motion_on_paths(const std::vector<Tool>& tools, double from, double to);

/// A motion from `from` to `to` [s].
struct TimedMotion {
  ToolMotion motion;
  double from, to;
};
/// The part of it between two shares: along their paths for tools that it leads from place to place of these, so that
/// what they carry has their acceleration within a step, too; straight for others, which a hand leads.
ToolMotion part_of(const std::vector<Tool>& tools, const TimedMotion& whole, double from_share, double to_share);

}  // namespace fascia
