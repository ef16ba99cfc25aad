#include "app/session/replay_view.h"

#include <algorithm>
#include <cmath>

#include "sim/replay/replay_time.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// [s] largest interval between consecutive pictures: across a longer one the camera did not move.
constexpr double kLongestMove = 0.15;

bool same_lens(const CameraSettings& a, const CameraSettings& b) { return a.up == b.up && a.fov_deg == b.fov_deg; }

// The interpolated quantities: target, direction, logarithm of the distance.
struct Pose {
  Vector3d target, direction;
  double distance;
  explicit Pose(const CameraSettings& c)
      : target(c.target), direction((c.eye - c.target).normalized()), distance(std::log((c.eye - c.target).norm())) {}
};

template <class T>
T hermite(const T& a, const T& b, const T& slope_a, const T& slope_b, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * slope_a + (3 * t2 - 2 * t3) * b + (t3 - t2) * slope_b;
}

}  // namespace

ReplayView::ReplayView(const Replay& replay) {
  const ReplayTime time(replay);
  for (const Input& input : replay.inputs) {
    const auto step = static_cast<double>(input.step);
    if (const auto* display = std::get_if<DisplaySettings>(&input.change)) displays_.emplace_back(step, *display);
    const auto* camera = std::get_if<CameraSettings>(&input.change);
    if (!camera) continue;
    const double gap = kLongestMove / time.time_step(input.step);
    if (!keys_.empty() && keys_.back().step == step) keys_.pop_back();
    // A camera at rest begins to move one picture before its next recorded position.
    if (!keys_.empty() && step - keys_.back().step > std::max(gap, 1.0))
      keys_.push_back({step - std::max(gap / 4, 1.0), keys_.back().camera});
    keys_.push_back({step, *camera});
  }
}

std::optional<CameraSettings> ReplayView::camera(double step) const {
  const auto next =
      std::upper_bound(keys_.begin(), keys_.end(), step, [](double s, const Key& key) { return s < key.step; });
  if (next == keys_.begin()) return std::nullopt;
  const auto from = next - 1;
  if (next == keys_.end() || from->camera == next->camera || !same_lens(from->camera, next->camera))
    return from->camera;
  const Pose a(from->camera), b(next->camera);
  if (a.direction.dot(b.direction) < 0) return from->camera;  // a different view, not a rotation
  const double length = next->step - from->step, t = (step - from->step) / length;
  // Slopes over one interval, from the keys on both sides.
  const auto slope = [&](auto member) {
    const auto at = [&](std::vector<Key>::const_iterator key) { return Pose(key->camera).*member; };
    using T = std::decay_t<decltype(at(from))>;
    T before = length / (next->step - from->step) * (at(next) - at(from)), after = before;
    if (from != keys_.begin() && same_lens((from - 1)->camera, from->camera))
      before = length / (next->step - (from - 1)->step) * (at(next) - at(from - 1));
    if (next + 1 != keys_.end() && same_lens((next + 1)->camera, next->camera))
      after = length / ((next + 1)->step - from->step) * (at(next + 1) - at(from));
    return std::pair<T, T>(before, after);
  };
  const auto [target_a, target_b] = slope(&Pose::target);
  const auto [direction_a, direction_b] = slope(&Pose::direction);
  const auto [distance_a, distance_b] = slope(&Pose::distance);
  CameraSettings camera = from->camera;
  camera.target = hermite(a.target, b.target, target_a, target_b, t);
  const Vector3d direction = hermite(a.direction, b.direction, direction_a, direction_b, t).normalized();
  camera.eye = camera.target + std::exp(hermite(a.distance, b.distance, distance_a, distance_b, t)) * direction;
  return camera;
}

std::optional<DisplaySettings> ReplayView::display(double step) const {
  const auto next = std::upper_bound(displays_.begin(), displays_.end(), step,
                                     [](double s, const auto& entry) { return s < entry.first; });
  if (next == displays_.begin()) return std::nullopt;
  return (next - 1)->second;
}

}  // namespace fascia
