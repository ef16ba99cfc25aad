#include "sim/simulation/errors/mesh_error_in_motion.h"

#include "sim/accuracy/finer_solution.h"
#include "sim/simulation/errors/repeated_run.h"
#include "sim/simulation/errors/solver_error.h"

namespace fascia {
namespace {

bool is_too_large(const Model& model) {
  std::size_t quadratic = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) quadratic += model.is_quadratic(t) ? 1 : 0;
  return quadratic > FinerSolution::most_tets(ElementOrder::quadratic) ||
         model.tets.size() - quadratic > FinerSolution::most_tets(ElementOrder::linear);
}

}  // namespace

RunError estimate_mesh_error_in_motion(const Simulation& done, gl::ProgramCache* programs,
                                       const std::stop_token& stop) {
  if (done.replay() || is_too_large(done.model)) return {.complete = false};
  const std::optional<Trajectory> own = repeat_run(done, solved, programs, stop);
  const std::optional<Trajectory> finer = own ? repeat_on_refined_tets(done, solved, programs, stop) : std::nullopt;
  return finer ? error_of(*own, *finer) : RunError{.complete = false};
}

}  // namespace fascia
