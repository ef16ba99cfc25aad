#include "sim/simulation/errors/time_error.h"

#include "sim/simulation/errors/repeated_run.h"

namespace fascia {

bool damps(Integrator integrator) { return integrator != Integrator::sdirk2; }

int order_of(Integrator integrator) { return integrator == Integrator::implicit_euler ? 1 : 2; }

TimeError estimate_time_error(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  TimeExtrapolation extrapolation(order_of(done.scene.solver.integrator));
  for (int parts = 1; extrapolation.wants_more(); parts *= 2) {
    const auto divided = [parts](SolverSettings settings) {
      settings.substeps *= parts;
      return settings;
    };
    std::optional<Trajectory> motion =
        parts == 1 ? repeat_run(done, programs, stop) : repeat_run(done, divided, programs, stop);
    if (!motion) return {.complete = false};
    extrapolation.add(std::move(*motion));
  }
  if (damps(done.scene.solver.integrator)) {
    const auto hardly_damped = [](SolverSettings settings) {
      settings.substeps *= 4;
      settings.integrator = Integrator::sdirk2;
      return settings;
    };
    std::optional<Trajectory> witness = repeat_run(done, hardly_damped, programs, stop);
    if (!witness) return {.complete = false};
    extrapolation.add_witness(std::move(*witness));
  }
  return extrapolation.error();
}

}  // namespace fascia
