// The camera and display of a recorded session at any time, also between two steps.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

class ReplayView {
 public:
  ReplayView() = default;
  explicit ReplayView(const Replay& replay);

  /// The camera after `step` steps, whole or fractional. It follows a smooth path through the recorded cameras (Catmull
  /// and Rom 1974, in the target, the direction and the logarithm of the distance), and rests where it rested. None if
  /// none was recorded by then.
  std::optional<CameraSettings> camera(double step) const;
  std::optional<DisplaySettings> display(double step) const;
  bool has_camera() const { return !keys_.empty(); }

 private:
  struct Key {
    double step;
    CameraSettings camera;
  };
  std::vector<Key> keys_;
  std::vector<std::pair<double, DisplaySettings>> displays_;
};

}  // namespace fascia
