#include "sim/tool/led_tools.h"

#include <cmath>
#include <numbers>

#include "base/rotation.h"

namespace fascia {

ToolPlace LedPlace::place() const { return {{rotation_of(rotate_deg), position}, grip}; }

LedPlace led_place(const ToolPlace& place) {
  const Eigen::Matrix3d& r = place.pose.axes;
  const double across = std::hypot(r(0, 0), r(1, 0));
  const double y = std::atan2(-r(2, 0), across), z = across > 0 ? std::atan2(r(1, 0), r(0, 0)) : 0;
  constexpr double kDegrees = 180 / std::numbers::pi;
  // What the other two leave, so that nothing is lost where their axes nearly coincide.
  const Eigen::Matrix3d left = rotation_of({0, kDegrees * y, kDegrees * z}).transpose() * r;
  const double x = std::atan2(left(2, 1), left(1, 1));
  return {place.pose.origin, kDegrees * Eigen::Vector3d(x, y, z), place.grip};
}

void LedTools::lead(const LedTool& tool) {
  for (Led& led : led_)
    if (led.to.name == tool.name) {
      led.to = tool;
      return;
    }
  led_.push_back({tool, std::nullopt});
}

void LedTools::arrive() {
  for (Led& led : led_) led.from = led.to.place;
}

void LedTools::restart(const std::vector<LedTool>& tools) {
  led_.clear();
  for (const LedTool& tool : tools) led_.push_back({tool, tool.place});
}

std::vector<LedTool> LedTools::tools() const {
  std::vector<LedTool> tools;
  for (const Led& led : led_) tools.push_back(led.to);
  return tools;
}

ToolMotion LedTools::motion(const std::vector<Tool>& tools, double from, double to) const {
  ToolMotion motion = motion_on_paths(tools, from, to);
  for (std::size_t t = 0; t < tools.size(); ++t)
    for (const Led& led : led_) {
      if (led.to.name != tools[t].name) continue;
      motion.to[t] = led.to.place.place();
      if (led.from) motion.from[t] = led.from->place();
    }
  return motion;
}

}  // namespace fascia
