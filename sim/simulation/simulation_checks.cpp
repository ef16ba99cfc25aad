// Checks the state every few steps: whether it is finite, whether it has come to rest, whether the device computes.
#include <algorithm>

#include "sim/gpu/passes/compute_probe.h"
#include "sim/reference/static_residual.h"
#include "sim/simulation/simulation.h"

namespace fascia {

// The result of the last check has long been available, or is waited for: so a body falls asleep at the same step in
// every run.
void Simulation::look() {
  follow_check(true);
  if (diverged_) return;
  checked_step_ = steps_;
  gpu_->request_check();
  if (!quiet_ || time() < model.end_of_motions() || tools_disturb()) return settling_.cancel();
  follow_check(true);  // a sleeping state must be known to be valid
  asleep_ = quiet_ && !diverged_ && settle();
  if (asleep_) cover_tissue();
}

// Whether a body that hardly moves has come to rest. If its equilibrium can be found quickly, the body is put there.
bool Simulation::settle() {
  constexpr double kUnseen = 3e-4;             // of the scene's size: a third of a pixel
  constexpr double kLong = 1, kVeryLong = 16;  // [s] at rest
  constexpr double kFloat32 = 1e-3;            // of a static residual: rounding in soft slender bodies
  const bool descends = gpu_->descends();
  if (!descends) return rest_.quiet() >= kLong;  // such methods come to rest elsewhere
  // Friction holds a body at any of many places: it stays where it is, once its forces balance there.
  if (gpu_->last_had_contact() || model.tets.size() > Settling::kMostTets)
    return rest_.quiet() >= kLong &&
           (rest_.quiet() >= kVeryLong ||
            reference::StaticResidual(model)(gpu_->download(), springs_, gpu_->contact_forces()) <= kFloat32);
  if (!settling_.busy()) {
    if (rest_.quiet() < settles_after_) return false;
    Model apart = model;  // from tools, which are far away
    apart.tools.clear();
    State now = gpu_->download();
    now.contact.clear();
    settling_.begin(apart, scene.solver, springs_, std::move(now), steps_);
    return false;
  }
  if (!settling_.due(steps_)) return false;
  std::optional<State> equilibrium = settling_.take();
  if (!equilibrium) {
    settles_after_ = kVeryLong;
    return rest_.quiet() >= kVeryLong;
  }
  const State now = gpu_->download();
  double farthest = 0;
  for (std::size_t v = 0; v < now.displacement.size(); ++v)
    farthest = std::max(farthest, (equilibrium->displacement[v] - now.displacement[v]).norm());
  if (!(farthest <= kUnseen * gpu_->buffers().size)) {
    settles_after_ = 2 * std::max(rest_.quiet(), kLong);
    return false;
  }
  equilibrium_ = std::move(*equilibrium);
  equilibrium_->time = gpu_->time();
  gpu_->settle(*equilibrium_);
  return true;
}

void Simulation::follow_check(bool wait) {
  const std::optional<StateGuard::Verdict> verdict = gpu_->take_check(wait);
  if (!verdict) return;
  require_measured(verdict->measured);
  if (unproven_ && checked_step_ > 0) judge_device(*verdict);
  if (verdict->diverged) {
    diverged_ = verdict->diverged;
    return;
  }
  log_.forget_before(checked_step_);
  if (checked_step_ > woken_step_) quiet_ = rest_.add(verdict->movement, scene.solver, gpu_->buffers().size);
}

// Throws Error if no vertex has fallen.
void Simulation::judge_device(const StateGuard::Verdict& first) {
  unproven_ = false;
  diverged_from_the_start_ = first.diverged.has_value();
  const Movement& movement = first.movement;
  if (first.diverged || movement.way > 0 || movement.speed > 0 || movement.displacement > 0) return;
  const bool falls = woken_step_ == 0 && !model.gravity.isZero() && scene.solver.tolerance == 0;
  if (falls) require_computed(model, gpu_->download());
}

void Simulation::require_device() const {
  if (!diverged_from_the_start_) return;
  // Tissue whose forces overflow also diverges within a step. A box in its place distinguishes the two causes.
  const Model box = trial_model();
  SolverSettings settings;
  settings.method = scene.solver.method;
  settings.acceleration = scene.solver.acceleration;
  GpuSolver solver(*programs_, box, settings);
  solver.step();
  require_computed(box, solver.download());
}

std::optional<std::uint32_t> Simulation::check_now() {
  if (reference_) return std::nullopt;
  follow_check(true);
  if (diverged_) return diverged_;
  checked_step_ = steps_;
  gpu_->request_check();
  follow_check(true);
  return diverged_;
}

}  // namespace fascia
