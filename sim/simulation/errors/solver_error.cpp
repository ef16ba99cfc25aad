#include "sim/simulation/errors/solver_error.h"

#include <algorithm>

#include "sim/simulation/errors/repeated_run.h"

namespace fascia {

SolverSettings solved(SolverSettings settings) {
  if (settings.method != Method::two_level) {
    settings.method = Method::two_level;
    settings.acceleration = info_of(Method::two_level).accelerations.front();
  }
  settings.iterations = std::max(3 * settings.iterations, kFewestToSolve);
  settings.tolerance = 0;
  settings.frame_budget = 0;
  return settings;
}

RunError estimate_solver_error(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  const std::optional<Trajectory> own = repeat_run(done, programs, stop);
  const std::optional<Trajectory> truth = own ? repeat_run(done, solved, programs, stop) : std::nullopt;
  return truth ? error_of(*own, *truth) : RunError{.complete = false};
}

}  // namespace fascia
