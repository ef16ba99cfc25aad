// The start of a stage (sim/integrators/stage.h) and the solver's result, copied on the GPU and read when the copies
// are complete, so that no frame waits: for comparisons with the exact step.
#pragma once
#include <optional>

#include "gl/fence.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

struct SolvedStep {
  std::vector<Eigen::Vector3d> previous;   // [vertex_count] u at the start of the stage [m]
  std::vector<Eigen::Vector3d> from;       // [vertex_count] u* [m]
  std::vector<Eigen::Vector3d> predicted;  // [vertex_count] u~ [m], of constrained ones without gravity
  std::vector<Eigen::Vector3d> solution;   // [vertex_count] u at the end of the stage [m]
  ContactMemory contact;                   // at the start of the stage
};

class StepSnapshot {
 public:
  StepSnapshot() = default;
  StepSnapshot(const StepSnapshot&) = delete;
  StepSnapshot& operator=(const StepSnapshot&) = delete;

  /// Queues copies of the last stage's data. Needs a current context, as does take().
  void request(const SimBuffers& buffers);
  /// The result, once per request, when the copies are complete; with `wait`, waits for them. `buffers`: those of the
  /// request.
  std::optional<SolvedStep> take(const SimBuffers& buffers, bool wait);

 private:
  gl::Buffer previous_, from_, predicted_, solution_, contact_;
  gl::Fence fence_;
};

}  // namespace fascia
