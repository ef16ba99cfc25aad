#include "sim/tool/tool_motion.h"

namespace fascia {

ToolPlace between(const ToolPlace& from, const ToolPlace& to, double share) {
  if (share >= 1) return to;
  return {between(from.pose, to.pose, share), (1 - share) * from.grip + share * to.grip};
}

ToolMotion ToolMotion::part(double from_share, double to_share) const {
  if (from_share <= 0 && to_share >= 1) return *this;
  ToolMotion result;
  for (std::size_t t = 0; t < from.size(); ++t) {
    result.from.push_back(between(from[t], to[t], from_share));
    result.to.push_back(between(from[t], to[t], to_share));
  }
  return result;
}

ToolMotion part_of(const std::vector<Tool>& tools, const TimedMotion& whole, double from_share, double to_share) {
  if (from_share <= 0 && to_share >= 1) return whole.motion;
  const ToolMotion on_paths = motion_on_paths(tools, whole.from, whole.to);
  const auto time = [&](double share) { return whole.from + share * (whole.to - whole.from); };
  ToolMotion result = whole.motion.part(from_share, to_share);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (!(on_paths.from[t] == whole.motion.from[t] && on_paths.to[t] == whole.motion.to[t])) continue;
    result.from[t] = tools[t].place(time(from_share));
    if (to_share < 1) result.to[t] = tools[t].place(time(to_share));
  }
  return result;
}

ToolMotion motion_on_paths(const std::vector<Tool>& tools, double from, double to) {
  return {places_at(tools, from), places_at(tools, to)};
}

}  // namespace fascia
