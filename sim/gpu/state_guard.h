// Keeps a state to go back to. The last pass of every substep notes a vertex that is not finite or has run away
// (shaders/sim/velocity.comp); the guard copies that note and the state beside it on the GPU, so that no frame waits, and keeps the
// copy as soon as the note turns out to be empty.
#pragma once
#include <cstdint>
#include <optional>

#include "sim/gpu/sim_buffers.h"

namespace fascia {

class StateGuard {
 public:
  struct Verdict {
    std::optional<std::uint32_t> astray;  // a vertex that is lost; none: the state is kept as the last good one
  };

  StateGuard() = default;
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;
  ~StateGuard();

  /// The state is sound as it is: it has just been put there.
  void keep(SimBuffers& buffers, double time);
  /// Queues the copies, unless some are still under way. Needs a current context, as do the others and the destructor.
  void request(const SimBuffers& buffers, double time);
  /// Once for every request, when the copies are made; with `wait`, waits for them.
  std::optional<Verdict> take(bool wait);
  /// Back to the last sound state. Returns its time [s].
  double restore(SimBuffers& buffers);

 private:
  void clear(SimBuffers& buffers);

  struct Copy {
    gl::Buffer displacement, velocity;  // vec4 [vertex_count]
    double time = 0;
  };
  static void copy(const SimBuffers& buffers, double time, Copy& to);

  Copy good_, candidate_;
  gl::Buffer note_;
  GLsync fence_ = nullptr;
};

}  // namespace fascia
