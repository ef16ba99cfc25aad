#include "sim/fit/measured/drive.h"

#include <algorithm>

#include "base/error.h"

namespace fascia {
namespace {

// Samples of a path, between which it moves in one direction.
constexpr int kSamples = 2000;

}  // namespace

Drive::Drive(const Model& model, const std::string& where) {
  std::size_t count = 0;
  for (const Motion& motion : model.motions) {
    ++count;
    end_ = motion.start + motion.duration;
    const bool translates = motion.targets.empty() && motion.angle == 0 && motion.scale == 1;
    if (!translates)
      throw Error(where, "is the displacement of a motion that does not only translate", "expected time_s");
    const Eigen::Vector3d rest = model.rest_positions[motion.vertices.front()];
    distance_ = [motion, rest](double t) { return (motion.position(0, rest, t) - rest).norm(); };
  }
  for (const ResolvedGrab& grab : model.grabs) {
    ++count;
    end_ = grab.end();
    distance_ = [grab](double t) { return grab.displacement(t).norm(); };
  }
  for (const Tool& tool : model.tools) {
    if (tool.path.size() < 2) continue;
    ++count;
    end_ = tool.end();
    distance_ = [tool](double t) { return (tool.place(t).pose.origin - tool.place(0).pose.origin).norm(); };
  }
  if (count != 1)
    throw Error(where, "is the displacement of one of " + std::to_string(count) + " moved things",
                "expected one prescribed motion, grab or instrument in the scene, or time_s");
}

double Drive::farthest() const {
  double farthest = 0;
  for (int i = 0; i <= kSamples; ++i) farthest = std::max(farthest, distance_(end_ * i / kSamples));
  return farthest;
}

std::optional<double> Drive::time_of(double distance) const {
  constexpr double kRounding = 1e-9;  // of a file's digits, at the end of the path
  const double wanted = std::min(distance, farthest());
  if (distance > wanted * (1 + kRounding)) return std::nullopt;
  double low = 0, high = 0;
  for (int i = 0; i <= kSamples && distance_(high) < wanted; ++i) {
    low = high;
    high = end_ * i / kSamples;
  }
  for (int i = 0; i < 60 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    (distance_(middle) < wanted ? low : high) = middle;
  }
  return high;
}

}  // namespace fascia
