// The error of a motion in time, from the same motion with steps of 1, 1/2, 1/4, ... of its length. The ratio of the
// last two differences, over all moments and vertices, has the order at which errors fall, which contact, hands and
// fast vibrations keep below that of the integrator; from it follows the motion with infinitely short steps:
//
//   r = |u_n - u_n-1| / |u_n-1 - u_n-2|            2^-p at least, with the integrator's order p
//   u* = u_n + r / (1 - r) (u_n - u_n-1)           (Richardson 1911; Aitken 1926)
//
// Where all of these steps damp a vibration away, they agree on a motion without it. A witness, the same motion by an
// integrator that hardly damps, is then far from u*.
#pragma once
#include <optional>
#include <vector>

#include "sim/accuracy/trajectory.h"

namespace fascia {

/// Relative errors.
struct TimeError {
  double relative = 0;     // at the end: RMS error over RMS displacement, both over all vertices
  double over_run = 0;     // RMS error over RMS displacement, both over all moments and vertices
  double peak_stress = 0;  // of PeakStress::p99, at the end
  double order = 0;        // at which errors fall with the length of steps: 0 to that of the integrator
  bool resolved = true;    // false: errors hardly fall with the length of steps yet, and values are rough bounds
  bool complete = true;    // false: the repetition was stopped
};

class TimeExtrapolation {
 public:
  /// Steps are halved until errors fall at this order, or kMostHalvings times. Impacts have orders of a half to one.
  static constexpr double kLeastOrder = 0.5;
  static constexpr int kFewestHalvings = 2, kMostHalvings = 3;
  static constexpr double kFarthest = 2;

  explicit TimeExtrapolation(int order_of_integrator) : order_(order_of_integrator) {}

  /// From the longest steps on, each half as long as before.
  void add(Trajectory motion);
  /// Whether another motion, with shorter steps, is wanted.
  bool wants_more() const;
  void add_witness(Trajectory motion) { witness_ = std::move(motion); }
  /// From three motions or more. Where errors do not fall it is a bound, if they fall at kLeastOrder in shorter steps:
  /// the distance to the finest motion, or the change before the last where that is more, and what is left of that
  /// motion; at the end no less than over the run. So is the distance to a witness that is farther from u* than
  /// kFarthest times the estimate.
  TimeError error() const;

 private:
  double ratio() const;
  bool falls() const;

  int order_;
  std::vector<Trajectory> motions_;
  std::optional<Trajectory> witness_;
  std::vector<double> changes_;  // between neighbors: RMS over all moments and vertices [m]
};

}  // namespace fascia
