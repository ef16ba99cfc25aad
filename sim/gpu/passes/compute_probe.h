// Detects a graphics device that does not compute, so that it is not mistaken for a diverging simulation: some drivers
// accept every call and discard the work.
#pragma once
#include "gl/program.h"
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// Runs one small kernel and reads back its result. Throws Error, which names the device, if the result is wrong. Waits
/// for the GPU.
void require_computing(gl::ProgramCache& programs);

/// A box that hangs by one side: every working device moves it.
Model trial_model();

/// `state`: the result of the first steps under gravity. Throws Error, which names the device, if no free vertex is
/// finite or none has moved.
void require_computed(const Model& model, const State& state);
/// Throws Error unless a kernel that measured a state, after a step, did so.
void require_measured(bool measured);

}  // namespace fascia
