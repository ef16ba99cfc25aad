// Tools that a hand leads: they leave their paths with the first step in which it leads them. Their places are inputs
// of steps, which replays keep.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/tool/tool_motion.h"

namespace fascia {

/// The place of a tool in the numbers of files, from which the same bits follow every time.
struct LedPlace {
  Eigen::Vector3d position{0, 0, 0};    // [m]
  Eigen::Vector3d rotate_deg{0, 0, 0};  // about x, then y, then z
  double grip = 0;                      // 0 open to 1 closed
  ToolPlace place() const;
  bool operator==(const LedPlace&) const = default;
};
/// The same in these numbers, but for rounding. The axes of an instrument are not mirrored.
LedPlace led_place(const ToolPlace& place);

struct LedTool {
  std::string name;  // of an instrument
  LedPlace place;
  bool operator==(const LedTool&) const = default;
};

class LedTools {
 public:
  bool empty() const { return led_.empty(); }
  /// At this place at the end of the next step.
  void lead(const LedTool& tool);
  void arrive();  // the step was made
  /// Exactly these, without a motion in the next step.
  void restart(const std::vector<LedTool>& tools);
  std::vector<LedTool> tools() const;  // at the last places they were led to

  /// Of all tools of a model from one time to another [s]: the others are on their paths.
  ToolMotion motion(const std::vector<Tool>& tools, double from, double to) const;

 private:
  struct Led {
    LedTool to;
    std::optional<LedPlace> from;  // none: still on its path
  };
  std::vector<Led> led_;
};

}  // namespace fascia
