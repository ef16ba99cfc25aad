// Where inertia and gravity alone would lead: the start of every substep.
#pragma once
#include "gl/compute_pass.h"
#include "sim/gpu/passes/active_set.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

/// Where the iterations of a substep start: at u~, or at u~ without gravity's part of it.
struct Start {
  bool gravity = true;
  // Uint [vertex_count] not 0 where they start at u~ though `gravity` is false; null: nowhere
  const gl::Buffer* unconstrained = nullptr;
};

/// The first pass of every substep (shaders/sim/step/predict.comp). `copy_begin`: uint [vertex_count + 1], copies
/// before each vertex, of methods that split a vertex's mass between copies; null for those that do not. `active`: for
/// those vertices only; null: for all.
gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin,
                           const Start& start = {}, const ActiveSet* active = nullptr);

}  // namespace fascia
