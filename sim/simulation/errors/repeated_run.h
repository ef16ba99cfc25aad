// A run once more from its start, with other solver settings or other tets: what an error is measured against.
#pragma once
#include <functional>
#include <optional>

#include "base/interrupt.h"
#include "sim/accuracy/time_extrapolation.h"
#include "sim/simulation/simulation.h"

namespace fascia {

using ChangedSettings = std::function<SolverSettings(SolverSettings)>;

/// The motion of all steps of `done`, a scene or a replay whose values nothing else has changed, at up to ten moments.
/// Settings that a replay changes on the way go through `change`, too. Throws Error; none: stopped.
std::optional<Trajectory> repeat_run(const Simulation& done, const ChangedSettings& change, gl::ProgramCache* programs,
                                     const std::stop_token& stop);
/// With its own settings, to its own end: the budget of a frame may have granted it other iterations.
std::optional<Trajectory> repeat_run(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop);
/// Of a scene, on tets with more freedom (sim/accuracy/refined_bodies.h), on which its grabs take hold anew: the motion
/// of its own vertices. Precondition: no replay.
std::optional<Trajectory> repeat_on_refined_tets(const Simulation& done, const ChangedSettings& change,
                                                 gl::ProgramCache* programs, const std::stop_token& stop);
/// The same of its static equilibrium. Throws Error where there is none on these tets.
std::optional<Trajectory> settle_on_refined_tets(const Simulation& done, gl::ProgramCache* programs,
                                                 const std::stop_token& stop);

}  // namespace fascia
