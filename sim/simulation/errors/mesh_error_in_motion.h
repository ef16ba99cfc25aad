// The error of a run that its mesh has made: what every step lacks, as in sim/accuracy/mesh_error.h, and what later
// steps make of it, since a stiff mesh also swings too fast and slides and rolls otherwise.
#pragma once
#include "base/interrupt.h"
#include "sim/accuracy/trajectory.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// Repeats all steps of `done`, a scene whose values nothing else has changed, on its own tets and on finer ones
/// (sim/accuracy/refined_bodies.h): linear tets become quadratic, quadratic ones are cut in eight. Both in steps that
/// are solved (sim/simulation/errors/solver_error.h), as long as those of the run; errors are relative to the finer
/// run. Not complete for a replay, or more tets than FinerSolution::most_tets(). Takes 20 to 40 times the time of a run
/// with ten iterations. Throws Error.
RunError estimate_mesh_error_in_motion(const Simulation& done, gl::ProgramCache* programs,
                                       const std::stop_token& stop = interrupt_token());

/// The same of the static equilibrium that `done` is in, against that on finer tets. Hands and tools take hold of these
/// anew, so that the estimate has what the mesh does to their forces, which that of the state alone does not. Not
/// complete with more tets than kMostTetsAtRest, where the finer ones have no equilibrium, or for bodies that nothing
/// holds: how far they fell hides their shape, and friction holds them at any of many places.
RunError estimate_mesh_error_at_rest(const Simulation& done, gl::ProgramCache* programs,
                                     const std::stop_token& stop = interrupt_token());
constexpr std::size_t kMostTetsAtRest = 10'000;  // finer ones

}  // namespace fascia
