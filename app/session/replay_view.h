// What the user of a replay looked at: camera and display at any moment, between two steps, too.
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

  /// After `step` steps, whole or not. The camera goes through what was recorded on a smooth path (Catmull and Rom
  /// 1974, in the target, the direction and the logarithm of the distance), and stands where it stood. Nothing if none
  /// was recorded by then.
  std::optional<CameraSettings> camera(double step) const;
  std::optional<DisplaySettings> display(double step) const;

 private:
  struct Key {
    double step;
    CameraSettings camera;
  };
  std::vector<Key> keys_;
  std::vector<std::pair<double, DisplaySettings>> displays_;
};

}  // namespace fascia
