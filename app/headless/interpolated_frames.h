// Interpolates drawn positions for frames between two steps: on a smooth path through the positions of the steps
// (Catmull and Rom 1974), but never across a reset. The simulation must be some steps ahead of the picture.
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

  explicit InterpolatedFrames(const std::optional<Replay>& replay);  // its resets are jumps
  /// Stores the simulation's positions after step `step`; call once per step.
  void add(long step, Simulation& simulation);
  /// Positions after `step` steps, whole or fractional: vec4, as GpuSolver::positions, with the values of the colors.
  /// The surrounding steps must have been added.
  const gl::Buffer& at(double step);

 private:
  const std::vector<shared::vec4>& positions(long step) const;
  bool joined(long from, long to) const;  // one step apart, stored, and without a jump

  std::set<long> jumps_;  // steps before which the state was replaced
  long first_ = 0;
  std::deque<std::vector<shared::vec4>> known_;
  gl::Buffer between_;
};

}  // namespace fascia
