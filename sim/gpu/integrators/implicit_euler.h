// The passes of implicit Euler (sim/integrators/implicit_euler.h): the prediction that begins every substep, and the
// velocities at its end.
#pragma once
#include "gl/compute_pass.h"
#include "sim/gpu/passes/recording.h"

namespace fascia {

/// Where the iterations of a substep start: at u~, or at u~ without gravity's part of it.
struct Start {
  bool gravity = true;
  // uint [vertex_count] not 0 where they start at u~ though `gravity` is false; null: nowhere
  const gl::Buffer* unconstrained = nullptr;
};

/// The first pass of every substep (shaders/sim/step/predict.comp). `copy_begin`: uint [vertex_count + 1], copies
/// before each vertex, of methods that split a vertex's mass between copies; null for those that do not. `active`: for
/// those vertices only; null: for all.
gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin,
                           const Start& start = {}, const ActiveSet* active = nullptr);

/// The last pass of every substep (shaders/sim/step/velocity.comp): velocities, and the note of a vertex that diverged.
gl::ComputePass velocity_update(const Recording& recording);

}  // namespace fascia
