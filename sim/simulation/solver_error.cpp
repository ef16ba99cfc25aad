#include "sim/simulation/solver_error.h"

#include <algorithm>
#include <cmath>

#include "sim/accuracy/relative_distance.h"
#include "sim/simulation/repeated_run.h"

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

SolverError estimate_solver_error(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  const std::optional<Trajectory> own = repeat_run(done, programs, stop);
  const std::optional<Trajectory> truth = own ? repeat_run(done, solved, programs, stop) : std::nullopt;
  if (!truth) return {.complete = false};
  if (truth->displacement.empty()) return {};
  SolverError error;
  error.relative = relative_distance(own->displacement.back(), truth->displacement.back());
  std::vector<Eigen::Vector3d> all_own, all_true;
  for (std::size_t moment = 0; moment < truth->displacement.size(); ++moment) {
    all_own.insert(all_own.end(), own->displacement[moment].begin(), own->displacement[moment].end());
    all_true.insert(all_true.end(), truth->displacement[moment].begin(), truth->displacement[moment].end());
  }
  error.over_run = relative_distance(all_own, all_true);
  const double difference = std::abs(own->peak_stress - truth->peak_stress);
  error.peak_stress = difference == 0 ? 0 : difference / truth->peak_stress;
  return error;
}

}  // namespace fascia
