// Tells a graphics device that does not compute from tissue that breaks: drivers exist that accept every call and discard the work.
#pragma once
#include "render/gl/program.h"
#include "sim/reference/newton.h"

namespace fascia {

/// Runs one small kernel and reads back what it wrote. Throws Error, which names the device, where that is anything else. Waits for the GPU.
void require_computing(gl::ProgramCache& programs);

/// `state`: what the first steps made of a start. Throws Error, which names the device, where every vertex that may move is not finite, or
/// where none has moved although `must_move`.
void require_computed(const Model& model, const reference::State& state, bool must_move);

}  // namespace fascia
