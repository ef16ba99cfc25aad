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

double norm(const std::vector<Displacements>& motion) {
  double whole = 0;
  for (const Displacements& u : motion) whole = std::hypot(whole, norm(u));
  return whole;
}

double distance(const std::vector<Displacements>& a, const std::vector<Displacements>& b) {
  double whole = 0;
  for (std::size_t m = 0; m < a.size(); ++m) whole = std::hypot(whole, distance(a[m], b[m]));
  return whole;
}

double over(double error, double whole) { return error == 0 ? 0 : error / whole; }

}  // namespace

void TimeExtrapolation::add(Trajectory motion) {
  if (!motions_.empty()) changes_.push_back(distance(motion.displacement, motions_.back().displacement));
  motions_.push_back(std::move(motion));
}

double TimeExtrapolation::ratio() const {
  const double last = changes_.back(), earlier = changes_[changes_.size() - 2];
  return last == 0 ? 0 : last / earlier;
}

bool TimeExtrapolation::falls() const {
  return changes_.back() <= kRounding * norm(motions_.back().displacement) || ratio() <= std::pow(2, -kLeastOrder);
}

bool TimeExtrapolation::wants_more() const {
  const int halvings = static_cast<int>(changes_.size());
  return halvings < kFewestHalvings || (halvings < kMostHalvings && !falls());
}

TimeError TimeExtrapolation::error() const {
  const std::size_t n = motions_.size();
  const Trajectory &coarse = motions_[0], &a = motions_[n - 3], &b = motions_[n - 2], &c = motions_[n - 1];
  TimeError error;
  error.order = std::clamp(-std::log2(ratio()), 0.0, static_cast<double>(order_));
  const double r = std::clamp(ratio(), std::pow(2, -order_), std::pow(2, -kLeastOrder));
  const double gain = r / (1 - r);
  const double forward = falls() ? gain : 0;  // from the finest motion to the best one known: u* or itself
  std::vector<Displacements> best = c.displacement;
  for (std::size_t m = 0; m < best.size(); ++m)
    for (std::size_t v = 0; v < best[m].size(); ++v) best[m][v] += forward * (best[m][v] - b.displacement[m][v]);
  const bool doubted =
      witness_ && distance(witness_->displacement, best) >
                      std::max(kFarthest * distance(coarse.displacement, best), kRounding * norm(best));
  error.resolved = falls() && !doubted;
  if (doubted) error.order = 0;
  const auto estimate = [&](double to_best, double earlier_change, double last_change, double to_witness) {
    return std::max(falls() ? to_best : std::max(to_best, earlier_change) + gain * last_change, to_witness);
  };
  double squares = 0, end = 0;
  for (std::size_t m = 0; m < best.size(); ++m) {
    end = estimate(distance(coarse.displacement[m], best[m]), distance(a.displacement[m], b.displacement[m]),
                   distance(b.displacement[m], c.displacement[m]),
                   doubted ? distance(coarse.displacement[m], witness_->displacement[m]) : 0);
    squares += end * end;
  }
  // Runs whose long steps damped all vibrations agree at the end on what the motion does not do.
  if (!error.resolved) end = std::max(end, std::sqrt(squares / static_cast<double>(best.size())));
  error.relative = over(end, best.empty() ? 0 : norm(best.back()));
  error.over_run = over(std::sqrt(squares), norm(best));
  const double peak = c.peak_stress + forward * (c.peak_stress - b.peak_stress);
  const double off = estimate(std::abs(coarse.peak_stress - peak), std::abs(a.peak_stress - b.peak_stress),
                              std::abs(b.peak_stress - c.peak_stress),
                              doubted ? std::abs(coarse.peak_stress - witness_->peak_stress) : 0);
  error.peak_stress = peak == 0 ? 0 : over(off, std::abs(peak));  // 0: rounding
  return error;
}

}  // namespace fascia
