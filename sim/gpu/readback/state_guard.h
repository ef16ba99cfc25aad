// Keeps a state to go back to. The last pass of every substep records a vertex that is not finite or has left the scene
// (shaders/sim/step/velocity.comp); the guard copies that record and the state on the GPU, so that no frame waits, and
// keeps the copy as soon as the record proves empty. It also measures how much the state has moved since the kept one.
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
  struct Moment {
    double time = 0;          // of the state [s]
    double earlier_step = 0;  // State::Earlier::step
  };
  struct Verdict {
    std::optional<std::uint32_t>
        diverged;          // the place of a vertex that diverged; none: the state is kept as the last valid one
    Movement movement;     // since the valid state before it
    bool measured = true;  // else the driver has discarded the dispatch
  };

  StateGuard(gl::ProgramCache& programs, SimBuffers& buffers);
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

  /// Keeps the state without a check: it was set from outside and is valid.
  void keep(SimBuffers& buffers, const Moment& moment);
  /// The kept state is still the current one: time has passed and nothing moved.
  void pass_time(double seconds) { good_.moment = {good_.moment.time + seconds}; }
  /// Queues the measurement and the copies, unless earlier ones are still pending. Needs a current context, as do the
  /// other functions.
  void request(const SimBuffers& buffers, const Moment& moment);
  /// The result, once per request, when the copies are complete; with `wait`, waits for them.
  std::optional<Verdict> take(bool wait);
  /// Restores the last valid state.
  Moment restore(SimBuffers& buffers);
  State download(const SimBuffers& buffers) const;  // of the kept state; waits for the GPU

 private:
  void clear(SimBuffers& buffers);

  struct Copy {
    gl::Buffer displacement, velocity;                                  // vec4 [vertex_count]
    gl::Buffer earlier_displacement, earlier_velocity, contact_memory;  // where SimBuffers has them
    Moment moment;
  };
  static void copy(const SimBuffers& buffers, const Moment& moment, Copy& to);

  Copy good_, candidate_;
  gl::ProgramCache& programs_;
  gl::Buffer motion_;  // uint [4] (shaders/sim/readback/motion.comp); created at the first request, as the next two
  gl::Buffer note_;    // uint [5] copy of SimBuffers::diverged, then of motion_
  std::optional<gl::ComputePass> measure_;
  gl::Fence fence_;
};

}  // namespace fascia
