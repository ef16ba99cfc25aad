#include "sim/simulation/errors/worst_step.h"

#include <algorithm>

namespace fascia {
namespace {

constexpr double kAffordable = 200'000;  // tets in all steps compared: some 10 s on one core

}  // namespace

WorstStep::WorstStep(std::size_t tets, long steps)
    : every_(1 + static_cast<long>(static_cast<double>(tets) * static_cast<double>(steps) / kAffordable)) {}

void WorstStep::look(Simulation& simulation) {
  if (simulation.model.tets.size() > kMostTets || simulation.uses_reference()) return;
  simulation.gpu()->request_diagnostics();
  const std::optional<Diagnostics> diagnostics = simulation.gpu()->take_diagnostics(true);
  const double residual = diagnostics ? diagnostics->residual : 0;
  if (simulation.steps_made() % every_ != 0 && !(residual > 2 * residual_)) return;
  residual_ = std::max(residual, residual_);
  add(measured_.measure_solver(simulation), simulation.time());
}

void WorstStep::add(const StepError& error, double time) {
  ++compared_;
  displacement_ = std::max(displacement_, error.displacement);
  if (error.rms < rms_) return;
  rms_ = error.rms;
  time_ = time;
}

}  // namespace fascia
