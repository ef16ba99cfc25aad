#include "app/headless/render_camera.h"

#include <charconv>

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

RenderCamera::RenderCamera(const std::string& choice, const Scene& scene, const Replay* replay) {
  if (choice == "follow") {
    if (replay) path_ = ReplayView(*replay);
    return;
  }
  if (choice == "scene") return;  // the initial camera
  still_ = read_eye_and_target(choice, scene.camera.value_or(CameraSettings()));
  if (still_) return;
  if (lower_ending(choice) == ".fascia") {
    path_ = ReplayView(read_replay(choice));
    return;
  }
  if (lower_ending(choice) != ".json")
    throw UsageError("--camera " + choice, "is no camera" + perhaps(choice, {"follow", "scene"}),
                     "expected follow, scene, a scene or replay file, or EYE,TARGET as six numbers");
  still_ = open_scene(choice).camera;
  if (!still_) throw Error("--camera " + choice, "has no camera", "expected a scene with the key camera");
}

std::optional<CameraSettings> RenderCamera::at(double step) const { return still_ ? still_ : path_.camera(step); }

}  // namespace fascia
