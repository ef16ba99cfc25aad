// The error of a run that its solver has made: what every step leaves unsolved, and what later steps make of it.
#pragma once
#include "base/interrupt.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// Relative errors, against the run with steps that are solved.
struct SolverError {
  double relative = 0;     // at the end: RMS error over RMS displacement, both over all vertices
  double over_run = 0;     // RMS error over RMS displacement, both over ten moments and all vertices
  double peak_stress = 0;  // of PeakStress::p99, at the end
  bool complete = true;    // false: the repetition was stopped
};

/// The settings of steps that count as solved: `two_level` with three times the iterations, at least kFewestToSolve.
SolverSettings solved(SolverSettings settings);
constexpr int kFewestToSolve = 30;

/// Repeats all steps of `done`, a run by the GPU whose values nothing else has changed, with its own settings and with
/// `solved()` ones. Takes 4 times the time of a run with ten iterations or more. Throws Error.
SolverError estimate_solver_error(const Simulation& done, gl::ProgramCache* programs,
                                  const std::stop_token& stop = interrupt_token());

}  // namespace fascia
