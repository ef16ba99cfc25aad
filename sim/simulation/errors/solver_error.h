// The error of a run that its solver has made: what every step leaves unsolved, and what later steps make of it.
#pragma once
#include "base/interrupt.h"
#include "sim/accuracy/trajectory.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// The settings of steps that count as solved: `two_level` with three times the iterations, at least kFewestToSolve.
SolverSettings solved(SolverSettings settings);
constexpr int kFewestToSolve = 30;

/// Repeats all steps of `done`, a run by the GPU whose values nothing else has changed, with its own settings and with
/// `solved()` ones; errors are relative to the latter. Takes 4 times the time of a run with ten iterations or more.
/// Throws Error.
RunError estimate_solver_error(const Simulation& done, gl::ProgramCache* programs,
                               const std::stop_token& stop = interrupt_token());

}  // namespace fascia
