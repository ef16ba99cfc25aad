#include "app/headless/render_camera.h"

#include <charconv>
#include <cmath>

#include "app/cli/usage_error.h"
#include "base/file.h"
#include "base/suggest.h"

namespace fascia {
namespace {

// Parses six numbers; none for other text.
std::optional<CameraSettings> read_eye_and_target(const std::string& text, CameraSettings camera) {
  double numbers[6];
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int k = 0; k < 6; ++k) {
    const auto [stop, error] = std::from_chars(at, end, numbers[k]);
    if (error != std::errc{} || (k < 5 ? stop == end || *stop != ',' : stop != end)) return std::nullopt;
    at = stop + 1;
  }
  camera.eye = {numbers[0], numbers[1], numbers[2]};
  camera.target = {numbers[3], numbers[4], numbers[5]};
  const Eigen::Vector3d view = camera.target - camera.eye;
  if (!(view.cross(camera.up).norm() > 1e-6 * view.norm() * camera.up.norm()))
    throw Error("--camera " + text, "looks along the scene's up direction, or at its own place",
                "expected an eye beside or before its target");
  return camera;
}

}  // namespace

Turntable parse_turntable(const std::string& text) {
  constexpr double kLongest = 86400, kMostDegrees = 360000;  // [s] a day, and a thousand turns
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const std::string unit(stop, end);
  if (error == std::errc{} && unit == "s" && number > 0 && number <= kLongest) return {number, 0};
  if (error == std::errc{} && unit == "deg" && number != 0 && std::abs(number) <= kMostDegrees) return {{}, number};
  throw UsageError(
      "--turntable", "is " + text,
      "expected seconds of the video for one turn, such as 8s, or degrees in the whole video, such as 360deg");
}

RenderCamera::RenderCamera(const std::string& choice, const Scene& scene, const Replay* replay,
                           const CameraSettings& framed)
    : still_(scene.camera.value_or(framed)) {
  if (choice == "follow" && replay) {
    path_ = ReplayView(*replay);
    if (path_.has_camera()) return;
  }
  if (choice == "follow" || choice == "scene") {
    take(scene, framed);
    return;
  }
  if (const auto given = read_eye_and_target(choice, scene.camera.value_or(CameraSettings()))) {
    still_ = *given;
    return;
  }
  if (lower_ending(choice) == ".fascia") {
    path_ = ReplayView(read_replay(choice));
    return;
  }
  if (lower_ending(choice) != ".json")
    throw UsageError("--camera " + choice, "is not a camera" + perhaps(choice, {"follow", "scene"}),
                     "expected follow, scene, a scene or replay file, or EYE,TARGET as six numbers");
  const Scene other = open_scene(choice);
  if (!other.camera && other.camera_motion.keys.empty())
    throw Error("--camera " + choice, "has no camera", "expected a scene with the key camera");
  take(other, framed);
}

void RenderCamera::take(const Scene& scene, const CameraSettings& framed) {
  still_ = scene.camera.value_or(framed);
  framed_ = !scene.camera;
  if (!scene.camera_motion.keys.empty()) keys_.emplace(scene.camera_motion, still_, scene.file.string());
}

CameraSettings RenderCamera::at(double step, double time) const {
  const CameraSettings camera = untouched(step, time);
  return turn_ != 0 ? turned(camera, turn_ * time) : camera;
}

CameraSettings RenderCamera::untouched(double step, double time) const {
  return keys_ ? keys_->at(time) : path_.camera(step).value_or(still_);
}

}  // namespace fascia
