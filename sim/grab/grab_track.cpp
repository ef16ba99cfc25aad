#include "sim/grab/grab_track.h"

#include <limits>

namespace fascia {
namespace {

constexpr std::size_t kMostParts = 8;  // grabs; with more, the springs count as new ones
// A grab adds its offset to the original place of a vertex: two such sums differ by the offsets' difference, apart from
// a few roundings.
constexpr double kRoundings = 16 * std::numeric_limits<double>::epsilon();

}  // namespace

std::optional<GrabMove> GrabTrack::follow(std::vector<GrabSpring>& springs) const {
  if (springs.empty() || springs.size() != base_.size()) return std::nullopt;
  GrabMove move;
  std::vector<GrabSpring> result;
  result.reserve(springs.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    GrabSpring led = base_[i];
    const Eigen::Vector3d& target = springs[i].target;
    const auto lead = [&](const Eigen::Vector3d& offset) {
      led.target = base_[i].target + offset;
      const double scale = std::max({target.lpNorm<Eigen::Infinity>(), base_[i].target.lpNorm<Eigen::Infinity>(),
                                     offset.lpNorm<Eigen::Infinity>()});
      return (led.target - target).lpNorm<Eigen::Infinity>() <= kRoundings * scale;
    };
    if (move.parts.empty() || !lead(move.parts.back().offset)) {
      if (move.parts.size() == kMostParts) return std::nullopt;
      move.parts.push_back({0, target - base_[i].target});
      if (!lead(move.parts.back().offset)) return std::nullopt;
    }
    ++move.parts.back().count;
    GrabSpring same = springs[i];
    same.target = led.target;
    if (!(same == led)) return std::nullopt;  // another vertex, stiffness or grab
    result.push_back(led);
  }
  springs = std::move(result);
  return move;
}

bool GrabTrack::fits(const GrabMove& move) const {
  std::size_t count = 0;
  for (const GrabMove::Part& part : move.parts) {
    if (part.count > base_.size() - count) return false;
    count += part.count;
  }
  return count == base_.size();
}

std::vector<GrabSpring> GrabTrack::moved(const GrabMove& move) const {
  std::vector<GrabSpring> springs = base_;
  std::size_t i = 0;
  for (const GrabMove::Part& part : move.parts)
    for (std::size_t k = 0; k < part.count; ++k) springs[i++].target += part.offset;
  return springs;
}

}  // namespace fascia
