// The error of a run in time, by the same run with steps of half the length.
#pragma once
#include "base/interrupt.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// The error of a motion falls with the length of its steps to this power.
int order_of(Integrator integrator);
/// The error of a motion over its distance to that with steps of half the length: 2^p / (2^p - 1) at order p
/// (Richardson 1911).
double richardson_factor(Integrator integrator);

struct TimeError {
  double relative = 0;     // RMS error over RMS displacement, both over all vertices
  bool complete = true;    // false: `stop` ended the repetition
  double peak_stress = 0;  // of PeakStress::p99, the same way
};

/// Of `coarse`, from the same motion with steps of half the length.
TimeError distance_in_time(const Model& model, Integrator integrator, const State& coarse, const State& fine);

/// Repeats all steps of `done`, a scene or a replay whose values nothing else has changed, from their start with twice
/// the substeps, by the same solver, and takes the error from the distance. What the solver leaves of each step is part
/// of it. Takes twice the time of the run. Throws Error.
TimeError estimate_time_error(const Simulation& done, gl::ProgramCache* programs,
                              const std::stop_token& stop = interrupt_token());

}  // namespace fascia
