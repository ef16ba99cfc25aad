#include "sim/simulation/errors/mesh_error_in_motion.h"

#include "base/error.h"
#include "sim/accuracy/finer_solution.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/rigid_motions.h"
#include "sim/simulation/errors/repeated_run.h"
#include "sim/simulation/errors/solver_error.h"

namespace fascia {
namespace {

std::size_t quadratic_tets(const Model& model) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) count += model.is_quadratic(t) ? 1 : 0;
  return count;
}

bool is_too_large(const Model& model) {
  const std::size_t quadratic = quadratic_tets(model);
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

RunError estimate_mesh_error_at_rest(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  constexpr std::size_t kPartsOfQuadratic = 8;
  const std::size_t finer_tets = done.model.tets.size() + (kPartsOfQuadratic - 1) * quadratic_tets(done.model);
  const bool held = free_pieces(done.model.tets, done.model.held()).empty();
  if (done.replay() || !held || finer_tets > kMostTetsAtRest) return {.complete = false};
  const State state = done.state();
  const Trajectory own{{state.displacement}, peak_beyond_rounding(done.model, state, stop)};
  try {
    const std::optional<Trajectory> finer = settle_on_refined_tets(done, programs, stop);
    return finer ? error_of(own, *finer) : RunError{.complete = false};
  } catch (const Error&) {  // what fell over or was crushed where it had less freedom
    return {.complete = false};
  }
}

}  // namespace fascia
