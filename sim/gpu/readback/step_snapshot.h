// What a substep started from and what the solver made of it, copied on the GPU and read when it is there, so that no
// frame waits: for comparisons with the exact step.
#pragma once
#include <optional>

#include "gl/fence.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

struct SolvedStep {
  std::vector<Eigen::Vector3d> previous;  // [vertex_count] u_n [m]
  std::vector<Eigen::Vector3d>
      predicted;  // [vertex_count] u~, where inertia, gravity and prescribed motions alone lead [m]
  std::vector<Eigen::Vector3d> solution;  // [vertex_count] u_n+1 [m]
};

class StepSnapshot {
 public:
  StepSnapshot() = default;
  StepSnapshot(const StepSnapshot&) = delete;
  StepSnapshot& operator=(const StepSnapshot&) = delete;

  /// Queues copies of what the last substep left. Needs a current context, as does take().
  void request(const SimBuffers& buffers);
  /// Once for every request, when the copies are made; with `wait`, waits for them. `buffers`: those that were asked.
  std::optional<SolvedStep> take(const SimBuffers& buffers, bool wait);

 private:
  gl::Buffer previous_, predicted_, solution_;
  gl::Fence fence_;
};

}  // namespace fascia
