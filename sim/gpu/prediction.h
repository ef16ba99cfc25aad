// Where inertia and gravity alone would lead: the start of every substep.
#pragma once
#include "render/gl/compute_pass.h"
#include "sim/gpu/active_set.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

/// The first pass of every substep (shaders/sim/predict.comp). `copy_begin`: uint [vertex_count + 1], copies before each vertex, of
/// methods that split a vertex's mass between copies; null for those that do not. `gravity_at_start`: the iterations start at u~. `active`:
/// for those vertices only; null: for all.
gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin,
                           bool gravity_at_start = true, const ActiveSet* active = nullptr);

}  // namespace fascia
