// The camera of a headless picture: a recorded one, the scene's, or one from the command line.
#pragma once
#include <optional>
#include <string>

#include "app/session/replay_view.h"

namespace fascia {

class RenderCamera {
 public:
  /// `choice`: "follow" (that of `replay`, if there is one), "scene", eye and target as six comma-separated numbers, a
  /// scene file with a camera, or a replay whose camera is followed. Throws Error.
  RenderCamera(const std::string& choice, const Scene& scene, const Replay* replay);
  /// The camera after `step` steps, whole or fractional; none: unchanged.
  std::optional<CameraSettings> at(double step) const;

 private:
  std::optional<CameraSettings> still_;
  ReplayView path_;
};

}  // namespace fascia
