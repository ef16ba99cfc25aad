// Drawn positions between two steps, for frames that fall there: on a smooth path through those of the steps (Catmull
// and Rom 1974), but never across a reset. The simulation must be some steps ahead of the picture.
#pragma once
#include <deque>
#include <set>
#include <vector>

#include "gl/buffer.h"
#include "shaders/shared/types.h"
#include "sim/simulation/simulation.h"

namespace fascia {

class InterpolatedFrames {
 public:
  static constexpr long kAhead = 2;  // steps

  explicit InterpolatedFrames(const std::optional<Replay>& replay);  // whose resets are jumps
  /// The simulation's positions, after step `step`; each step once.
  void add(long step, Simulation& simulation);
  /// Positions after `step` steps, whole or not: vec4, as GpuSolver::positions, with what colors them. Of the steps
  /// around it those must have been added.
  const gl::Buffer& at(double step);

 private:
  const std::vector<shared::vec4>& positions(long step) const;
  bool joined(long from, long to) const;  // one step apart, known, and no jump

  std::set<long> jumps_;  // steps before which the state was replaced
  long first_ = 0;
  std::deque<std::vector<shared::vec4>> known_;
  gl::Buffer between_;
};

}  // namespace fascia
