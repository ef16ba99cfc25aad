// The trial runs of fascia refine.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/refine/plan.h"
#include "gl/program.h"

namespace fascia {

/// Runs the scene with every kind of elements and the integrators implicit_euler and bdf2, `steps` steps each, and
/// measures errors and times; quadratic elements only with a method that carries them. `say` receives a line for each
/// run. Ctrl-C ends it with fewer trials. Throws Error.
std::vector<Trial> run_trials(const Scene& scene, gl::ProgramCache& programs, long steps,
                              const std::function<void(const std::string&)>& say);

/// One more, with these elements, this integrator and so many substeps. Throws Error.
Trial run_trial(const Scene& scene, gl::ProgramCache& programs, long steps, const Proposal& choice,
                const std::function<void(const std::string&)>& say);

}  // namespace fascia
