#include "sim/accuracy/time_extrapolation.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

using Displacements = std::vector<Eigen::Vector3d>;

// Of the displacement: changes below it are rounding in float32, which no shorter step makes smaller.
constexpr double kRounding = 1e-6;

double norm(const Displacements& u) {
  double squared = 0;
  for (const Eigen::Vector3d& displacement : u) squared += displacement.squaredNorm();
  return std::sqrt(squared);
}

double distance(const Displacements& a, const Displacements& b) {
  double squared = 0;
  for (std::size_t v = 0; v < a.size(); ++v) squared += (a[v] - b[v]).squaredNorm();
  return std::sqrt(squared);
}

double over(double error, double whole) { return error == 0 ? 0 : error / whole; }

}  // namespace

void TimeExtrapolation::add(Trajectory motion) {
  if (!motions_.empty()) {
    double change = 0;
    for (std::size_t m = 0; m < motion.displacement.size(); ++m)
      change = std::hypot(change, distance(motion.displacement[m], motions_.back().displacement[m]));
    changes_.push_back(change);
  }
  motions_.push_back(std::move(motion));
}

double TimeExtrapolation::ratio() const {
  const double last = changes_.back(), earlier = changes_[changes_.size() - 2];
  return last == 0 ? 0 : last / earlier;
}

bool TimeExtrapolation::falls() const {
  double whole = 0;
  for (const Displacements& u : motions_.back().displacement) whole = std::hypot(whole, norm(u));
  return changes_.back() <= kRounding * whole || ratio() <= std::pow(2, -kLeastOrder);
}

bool TimeExtrapolation::wants_more() const {
  const int halvings = static_cast<int>(changes_.size());
  return halvings < kFewestHalvings || (halvings < kMostHalvings && !falls());
}

TimeError TimeExtrapolation::error() const {
  const std::size_t n = motions_.size();
  const Trajectory &coarse = motions_[0], &a = motions_[n - 3], &b = motions_[n - 2], &c = motions_[n - 1];
  TimeError error;
  error.resolved = falls();
  error.order = std::clamp(-std::log2(ratio()), 0.0, static_cast<double>(order_));
  const double r = std::clamp(ratio(), std::pow(2, -order_), std::pow(2, -kLeastOrder));
  const double gain = r / (1 - r);
  const double forward = error.resolved ? gain : 0;  // from the finest motion to the best one known: u* or itself
  const auto estimate = [&](double to_best, double earlier_change, double last_change) {
    return error.resolved ? to_best : std::max(to_best, earlier_change) + gain * last_change;
  };
  double squares = 0, whole = 0, end = 0, size_at_end = 0;
  for (std::size_t m = 0; m < c.displacement.size(); ++m) {
    Displacements best = c.displacement[m];
    for (std::size_t v = 0; v < best.size(); ++v) best[v] += forward * (best[v] - b.displacement[m][v]);
    const double here = estimate(distance(coarse.displacement[m], best), distance(a.displacement[m], b.displacement[m]),
                                 distance(b.displacement[m], c.displacement[m]));
    const double size = norm(best);
    squares += here * here;
    whole += size * size;
    end = here;
    size_at_end = size;
  }
  // Runs whose long steps damped all vibrations agree at the end on what the motion does not do.
  if (!error.resolved) end = std::max(end, std::sqrt(squares / static_cast<double>(c.displacement.size())));
  error.relative = over(end, size_at_end);
  error.over_run = over(std::sqrt(squares), std::sqrt(whole));
  const double best = c.peak_stress + forward * (c.peak_stress - b.peak_stress);
  error.peak_stress = over(estimate(std::abs(coarse.peak_stress - best), std::abs(a.peak_stress - b.peak_stress),
                                    std::abs(b.peak_stress - c.peak_stress)),
                           std::abs(best));
  return error;
}

}  // namespace fascia
