// The camera of pictures that nobody looks at: the one that was recorded, the scene's, or one that is named.
#pragma once
#include <optional>
#include <string>

#include "app/session/replay_view.h"

namespace fascia {

class RenderCamera {
 public:
  /// `choice`: "follow" (that of `replay`, where there is one), "scene", eye and target as six numbers with commas
  /// between them, a scene file that has a camera, or a replay whose camera is followed. Throws Error.
  RenderCamera(const std::string& choice, const Scene& scene, const Replay* replay);
  /// After `step` steps, whole or not; nothing: as it is.
  std::optional<CameraSettings> at(double step) const;

 private:
  std::optional<CameraSettings> still_;
  ReplayView path_;
};

}  // namespace fascia
