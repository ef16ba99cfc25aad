#include "sim/model/scripted_hand.h"

#include <algorithm>
#include <cmath>

namespace fascia {

using Eigen::Vector3d;

Vector3d ScriptedHand::displacement(double t) const {
  if (t <= path.front().time) return path.front().displacement;
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (t >= path[k].time) continue;
    const double s = (t - path[k - 1].time) / (path[k].time - path[k - 1].time);
    const double share = smooth ? s * s * (3 - 2 * s) : s;
    return (1 - share) * path[k - 1].displacement + share * path[k].displacement;
  }
  return path.back().displacement;
}

double ScriptedHand::end() const { return std::isfinite(release) ? release : std::max(start, path.back().time); }

namespace {

void add(const ScriptedHand& hand, const Vector3d& displacement, std::vector<GrabSpring>& springs) {
  for (GrabSpring spring : hand.grip) {
    spring.target = displacement;
    springs.push_back(spring);
  }
}

}  // namespace

std::vector<GrabSpring> with_hands(std::vector<GrabSpring> springs, std::span<const ScriptedHand> hands, double t) {
  for (const ScriptedHand& hand : hands)
    if (t > hand.start && t <= hand.release) add(hand, hand.displacement(t), springs);
  return springs;
}

std::vector<GrabSpring> with_hands_at_last(std::vector<GrabSpring> springs, std::span<const ScriptedHand> hands) {
  for (const ScriptedHand& hand : hands) add(hand, hand.path.back().displacement, springs);
  return springs;
}

}  // namespace fascia
