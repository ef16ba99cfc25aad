#include "sim/model/resolved_grab.h"

#include <algorithm>
#include <cmath>

namespace fascia {

using Eigen::Vector3d;

Vector3d ResolvedGrab::displacement(double t) const {
  if (t <= path.front().time) return path.front().displacement;
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (t >= path[k].time) continue;
    const double s = (t - path[k - 1].time) / (path[k].time - path[k - 1].time);
    const double share = smooth ? s * s * (3 - 2 * s) : s;
    return (1 - share) * path[k - 1].displacement + share * path[k].displacement;
  }
  return path.back().displacement;
}

double ResolvedGrab::end() const { return std::isfinite(release) ? release : std::max(start, path.back().time); }

namespace {

// [s] Times are sums of substeps: roundings must not decide in which step a hand takes or releases.
constexpr double kSameTime = 1e-9;

void add(const ResolvedGrab& grab, const Vector3d& displacement, std::vector<GrabSpring>& springs) {
  for (GrabSpring spring : grab.grip) {
    spring.target = displacement;
    springs.push_back(spring);
  }
}

}  // namespace

std::vector<GrabSpring> with_grabs(std::vector<GrabSpring> springs, std::span<const ResolvedGrab> grabs, double t) {
  for (const ResolvedGrab& grab : grabs)
    if (t > grab.start + kSameTime && t <= grab.release + kSameTime) add(grab, grab.displacement(t), springs);
  return springs;
}

std::vector<GrabSpring> with_grabs_at_last(std::vector<GrabSpring> springs, std::span<const ResolvedGrab> grabs) {
  for (const ResolvedGrab& grab : grabs) add(grab, grab.path.back().displacement, springs);
  return springs;
}

}  // namespace fascia
