#include "app/state/convergence.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// The settings that distinguish a line; the number of iterations and the time step are common to all.
bool same_line(const SolverSettings& a, const SolverSettings& b) {
  return a.choice() == b.choice() && a.colors == b.colors && a.window == b.window &&
         a.spectral_radius == b.spectral_radius;
}

}  // namespace

std::string short_name(const SolverSettings& settings) {
  const SolverChoice pair = settings.choice();
  std::string name = name_of(pair.method);
  if (pair.acceleration != Acceleration::none) name += std::string(" + ") + name_of(pair.acceleration);
  if (applies("colors", pair) && settings.colors > 0) name += ", " + std::to_string(settings.colors) + " colors";
  if (applies("window", pair)) name += ", window " + std::to_string(settings.window);
  return name;
}

std::vector<Convergence::Line> Convergence::lines() const {
  std::vector<Line> lines;
  for (const Probe& probe : probes_) lines.push_back(probe.line);
  return lines;
}

bool Convergence::can_pin(const SolverSettings& settings) const {
  const auto pinned = [&](const Probe& probe) { return same_line(probe.settings, settings); };
  return !probes_.empty() && probes_.size() < kMostLines && std::none_of(probes_.begin() + 1, probes_.end(), pinned);
}

void Convergence::pin(const SolverSettings& settings) {
  if (can_pin(settings)) probes_.push_back({settings, nullptr, {short_name(settings), {}, false}});
}

void Convergence::unpin(std::size_t line) {
  if (line > 0 && line < probes_.size()) probes_.erase(probes_.begin() + static_cast<std::ptrdiff_t>(line));
}

void Convergence::measure(Simulation& simulation, gl::ProgramCache& programs) {
  if (simulation.uses_reference()) return;
  const SolverSettings& current = simulation.scene.solver;
  if (probes_.empty()) probes_.push_back({});
  probes_[0].settings = current;
  next_ = next_ < probes_.size() ? next_ : 0;
  Probe& probe = probes_[next_++];
  probe.settings.iterations = current.iterations;
  probe.settings.time_step = current.time_step;
  probe.settings.substeps = current.substeps;
  probe.settings.integrator = current.integrator;
  if (!probe.solver) probe.solver = std::make_unique<GpuSolver>(programs, simulation.model, probe.settings);
  if (probe.solver->settings() != probe.settings) probe.solver->set_settings(probe.settings);
  probe.solver->follow(*simulation.gpu());
  probe.line = {short_name(probe.settings), {}, false};
  for (const Diagnostics& d : probe.solver->traced_substep()) {
    if (!d.finite || !std::isfinite(d.residual)) {
      probe.line.diverged = true;
      break;
    }
    probe.line.residuals.push_back(static_cast<float>(d.residual));
  }
}

void Convergence::forget() {
  for (Probe& probe : probes_) {
    probe.solver.reset();
    probe.line.residuals.clear();
  }
}

}  // namespace fascia
