// Tells a graphics device that does not compute from tissue that breaks: drivers exist that accept every call and
// discard the work.
#pragma once
#include "gl/program.h"
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// Runs one small kernel and reads back what it wrote. Throws Error, which names the device, where that is anything
/// else. Waits for the GPU.
void require_computing(gl::ProgramCache& programs);

/// A box that hangs by one side: every device that computes moves it.
Model trial_model();

/// `state`: what the first steps made of a start, with gravity. Throws Error, which names the device, where every
/// vertex that may move is not finite, or where none has moved.
void require_computed(const Model& model, const State& state);

}  // namespace fascia
