// The largest error of the solver over a run: a step that is far from the exact one, as at a hit, leaves a state from
// which the last step may well be exact.
#pragma once
#include "sim/simulation/errors/true_error.h"

namespace fascia {

/// Compares steps with the exact ones: all of short runs of small meshes, else some at equal distances, and all whose
/// residual is twice that of every one compared before.
class WorstStep {
 public:
  /// Largest mesh of which more than the last step is compared: each comparison factorizes it.
  static constexpr std::size_t kMostTets = 20'000;

  WorstStep(std::size_t tets, long steps);

  /// Call after every step but the last one.
  void look(Simulation& simulation);
  /// The last step, which is measured in any case.
  void add(const StepError& error, double time);

  int compared() const { return compared_; }
  double time() const { return time_; }  // [s] at the end of the worst step
  /// RMS |u - u_exact| of the worst step over the largest RMS displacement of the compared ones.
  double of_displacement() const { return displacement_ > 0 ? rms_ / displacement_ : 0; }

 private:
  TrueError measured_;
  long every_ = 1;  // steps
  double residual_ = 0, rms_ = 0, displacement_ = 0, time_ = 0;
  int compared_ = 0;
};

}  // namespace fascia
