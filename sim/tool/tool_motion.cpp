#include "sim/tool/tool_motion.h"

namespace fascia {

ToolMotion ToolMotion::part(double from_share, double to_share) const {
  if (from_share <= 0 && to_share >= 1) return *this;
  ToolMotion result;
  const auto place = [&](std::size_t t, double share) {
    return ToolPlace{between(from[t].pose, to[t].pose, share), (1 - share) * from[t].grip + share * to[t].grip};
  };
  for (std::size_t t = 0; t < from.size(); ++t) {
    result.from.push_back(place(t, from_share));
    result.to.push_back(place(t, to_share));
  }
  return result;
}

ToolMotion motion_on_paths(const std::vector<Tool>& tools, double from, double to) {
  return {places_at(tools, from), places_at(tools, to)};
}

}  // namespace fascia
