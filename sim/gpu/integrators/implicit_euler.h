// The passes of implicit Euler (sim/integrators/implicit_euler.h): the prediction that begins every substep, and the
// velocities at its end.
#pragma once
#include "gl/compute_pass.h"
#include "sim/gpu/passes/recording.h"

namespace fascia {

/// The start of a substep's iterations: u~, or u~ without the contribution of gravity.
struct Start {
  bool gravity = true;
  // uint [vertex_count]: not 0 for vertices that start at u~ even if `gravity` is false; null: none
  const gl::Buffer* unconstrained = nullptr;
};

/// The first pass of every substep (shaders/sim/step/predict.comp). `copy_begin`: uint [vertex_count + 1], the number
/// of copies before each vertex, for methods that split a vertex's mass between copies; null for others. `active`:
/// limits the pass to these vertices; null: all.
gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin,
                           const Start& start = {}, const ActiveSet* active = nullptr);

/// The last pass of every substep (shaders/sim/step/velocity.comp): velocities, and the index of a vertex that
/// diverged.
gl::ComputePass velocity_update(const Recording& recording);

}  // namespace fascia
