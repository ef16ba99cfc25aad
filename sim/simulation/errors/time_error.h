// The error of a run in time, by the same run with shorter steps.
#pragma once
#include "base/interrupt.h"
#include "sim/accuracy/time_extrapolation.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// The error of a smooth motion falls with the length of its steps to this power.
int order_of(Integrator integrator);
/// Whether it damps vibrations that are fast beside its steps, so that its runs need a witness (TimeExtrapolation).
bool damps(Integrator integrator);

/// Repeats all steps of `done`, a scene or a replay whose values nothing else has changed, from their start, by the
/// same solver, with their own substeps and with twice, four times and, where the changes do not fall, eight times as
/// many; where their integrator damps, also by SDIRK2 with four times as many. What the solver leaves of each step is
/// part of the error. Takes 15 or 23 times the time of the run, by SDIRK2 7 or 15 times. Throws Error.
TimeError estimate_time_error(const Simulation& done, gl::ProgramCache* programs,
                              const std::stop_token& stop = interrupt_token());

}  // namespace fascia
