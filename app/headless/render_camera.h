// The camera of a headless picture: a recorded one, the scene's, or one from the command line.
#pragma once
#include <optional>
#include <string>

#include "app/headless/camera_path.h"
#include "app/session/replay_view.h"

namespace fascia {

/// Option --turntable: the camera circles its target, in addition to its other motion.
struct Turntable {
  std::optional<double> seconds;  // of the video, for one turn; else
  double degrees = 0;             // in the whole video
};
/// "8s" or "360deg". Throws UsageError.
Turntable parse_turntable(const std::string& text);

class RenderCamera {
 public:
  /// `choice`: "follow" (that of `replay`, if it has recorded one, else the scene's), "scene", eye and target as six
  /// comma-separated numbers, a scene file with a camera, or a replay whose camera is followed. `framed`: that of a
  /// scene without a camera. Throws Error.
  RenderCamera(const std::string& choice, const Scene& scene, const Replay* replay, const CameraSettings& framed);
  /// Turns so far per simulated second, beside all other motion.
  void turn(double degrees_per_second) { turn_ = degrees_per_second; }

  /// The camera after `step` steps, whole or fractional, at this simulated time [s].
  CameraSettings at(double step, double time) const;
  double end() const { return keys_ ? keys_->end() : 0; }  // time of the last key of the scene's camera [s]
  bool moves() const { return keys_ || turn_ != 0; }
  /// Whether nobody chose the camera, so that reframe() may set another one.
  bool framed() const { return framed_ && !moves(); }
  void reframe(const CameraSettings& camera) { still_ = camera; }

 private:
  CameraSettings untouched(double step, double time) const;
  void take(const Scene& scene, const CameraSettings& framed);

  CameraSettings still_;
  bool framed_ = false;  // on the bodies
  ReplayView path_;
  std::optional<CameraPath> keys_;
  double turn_ = 0;
};

}  // namespace fascia
