// The trial runs of fascia refine.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/refine/plan.h"
#include "gl/program.h"
#include "sim/model/model.h"

namespace fascia {

struct OpenedScene {
  Scene scene;
  Model model;
};

struct TrialRuns {
  const Scene& scene;  // as opened
  /// The scene with --set texts more: a trial runs exactly what these options make.
  std::function<OpenedScene(const std::vector<std::string>& sets)> open;
  gl::ProgramCache& programs;
  long steps;
  std::function<void(const std::string&)> say;  // receives a line for each run
};

/// Runs the scene with every kind of elements and the integrators implicit_euler and bdf2, and measures errors and
/// times; quadratic elements only with a method that carries them. Ctrl-C ends it with fewer trials. Throws Error.
std::vector<Trial> run_trials(const TrialRuns& runs);

/// One more, of this choice, its iterations among those measured. `alike`: a trial that differs in its iterations only,
/// whose errors of mesh and time it takes over, or null. None where Ctrl-C ended it, and where the scene cannot be made
/// or run with another mesh. Throws Error.
std::optional<Trial> run_trial(const TrialRuns& runs, const Proposal& choice, const Trial* alike = nullptr);

}  // namespace fascia
