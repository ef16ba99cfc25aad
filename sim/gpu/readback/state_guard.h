// Keeps a state to go back to. The last pass of every substep notes a vertex that is not finite or has run away
// (shaders/sim/step/velocity.comp); the guard copies that note and the state beside it on the GPU, so that no frame
// waits, and keeps the copy as soon as the note turns out to be empty. It also measures how much the state has moved
// since the one it keeps.
#pragma once
#include <cstdint>
#include <optional>

#include "gl/compute_pass.h"
#include "gl/fence.h"
#include "sim/gpu/passes/reduction.h"
#include "sim/gpu/passes/sim_buffers.h"
#include "sim/model/rest_detector.h"

namespace fascia {

class StateGuard {
 public:
  struct Verdict {
    std::optional<std::uint32_t>
        diverged;       // the place of a vertex that is lost; none: the state is kept as the last good one
    Movement movement;  // since the good one before it
  };

  StateGuard(gl::ProgramCache& programs, SimBuffers& buffers);
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

  /// The state is sound as it is: it has just been put there.
  void keep(SimBuffers& buffers, double time);
  /// The kept state is still that of now: time has passed and nothing moved.
  void pass_time(double seconds) { good_.time += seconds; }
  /// Queues the measurement and the copies, unless some are still under way. Needs a current context, as do the others.
  void request(const SimBuffers& buffers, double time);
  /// Once for every request, when the copies are made; with `wait`, waits for them.
  std::optional<Verdict> take(bool wait);
  /// Back to the last sound state. Returns its time [s].
  double restore(SimBuffers& buffers);
  State download(const SimBuffers& buffers) const;  // of it; waits for the GPU

 private:
  void clear(SimBuffers& buffers);

  struct Copy {
    gl::Buffer displacement, velocity;  // vec4 [vertex_count]
    double time = 0;
  };
  static void copy(const SimBuffers& buffers, double time, Copy& to);

  Copy good_, candidate_;
  gl::ProgramCache& programs_;
  gl::Buffer motion_;  // uint [3] (shaders/sim/readback/motion.comp); this and the next two are made when first asked
  gl::Buffer note_;    // uint [4] copy of SimBuffers::diverged, then of motion_
  std::optional<gl::ComputePass> measure_;
  gl::Fence fence_;
};

}  // namespace fascia
