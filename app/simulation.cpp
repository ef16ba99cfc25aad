#include "app/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/drawn_surface.h"
#include "sim/error.h"
#include "sim/gpu/static_march.h"

namespace fascia {

Simulation::Simulation(Scene opened, gl::ProgramCache* programs, bool use_reference)
    : scene(std::move(opened)), model(build_model(scene)) {
  if (programs) gpu_ = std::make_unique<GpuSolver>(*programs, model, scene.solver, embedded_points(scene));
  if (use_reference) {
    reference_ = std::make_unique<reference::NewtonSolver>(model, scene.solver);
    reference_state_ = reference::initial_state(model);
  }
}

void Simulation::step() {
  equilibrium_.reset();
  if (!reference_) {
    if (scene.solver.frame_budget > 0)
      step_within_budget();
    else
      gpu_->step();
    return;
  }
  newton_report_ = reference_->step(reference_state_);
  if (gpu_) gpu_->upload(reference_state_);
}

void Simulation::step_within_budget() {
  SolverSettings fitting = scene.solver;
  if (ms_per_iteration_ > 0) {
    const double fit = fitting.frame_budget / (ms_per_iteration_ * fitting.substeps);
    fitting.iterations = static_cast<int>(std::clamp<double>(std::floor(fit), 1, fitting.iterations));
  }
  if (fitting.iterations != gpu_->settings().iterations) gpu_->set_settings(fitting);
  gl::Finish();  // what was queued before is not the step's
  const auto start = std::chrono::steady_clock::now();
  gpu_->step();
  gl::Finish();
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const double per_iteration = ms / (std::max(gpu_->last_iterations(), 1) * fitting.substeps);
  constexpr double kNews = 0.2;  // share of a new measurement: a hiccup must not halve the accuracy of many steps
  ms_per_iteration_ = ms_per_iteration_ > 0 ? (1 - kNews) * ms_per_iteration_ + kNews * per_iteration : per_iteration;
}

void Simulation::reset() {
  equilibrium_.reset();
  if (reference_) reference_state_ = reference::initial_state(model);
  if (gpu_) gpu_->reset();
}

double Simulation::time() const { return reference_ ? reference_state_.time : gpu_->time(); }

reference::NewtonReport Simulation::solve_static() {
  if (!reference_) {
    equilibrium_.emplace();
    return march_to_equilibrium(*gpu_, model, scene.solver.tolerance > 0 ? scene.solver.tolerance : 1e-5, *equilibrium_);
  }
  newton_report_ = reference_->solve_static(reference_state_, scene.solver.tolerance);
  if (!newton_report_.converged)
    throw Error(scene.file.string(),
                "static equilibrium not reached: relative residual " + std::to_string(newton_report_.relative_residual) +
                    " after " + std::to_string(newton_report_.iterations) + " Newton iterations",
                "expected a body that is held and a load it can carry");
  if (gpu_) gpu_->upload(reference_state_);
  return newton_report_;
}

void Simulation::set_settings(const SolverSettings& settings) {
  if (settings.pair() != scene.solver.pair()) ms_per_iteration_ = 0;
  scene.solver = settings;
  if (gpu_) gpu_->set_settings(settings);
  if (reference_) reference_ = std::make_unique<reference::NewtonSolver>(model, settings);
}

void Simulation::set_material(std::size_t index, const Material& material) {
  model.materials[index] = material;
  if (gpu_) gpu_->materials_changed();
  if (reference_) reference_ = std::make_unique<reference::NewtonSolver>(model, scene.solver);
}

void Simulation::set_gravity(const Eigen::Vector3d& gravity) {
  scene.gravity = model.gravity = gravity;
  if (gpu_) gpu_->materials_changed();
  if (reference_) reference_ = std::make_unique<reference::NewtonSolver>(model, scene.solver);
}

reference::State Simulation::state() const {
  return reference_ ? reference_state_ : equilibrium_ ? *equilibrium_ : gpu_->download();
}

double Simulation::mean_iterations() const {
  return gpu_ && !reference_ ? gpu_->mean_iterations() : scene.solver.iterations;
}

long steps_to_run(const CommonOptions& options, const Scene& scene) {
  if (options.steps) return *options.steps;
  return std::lround(options.time.value_or(scene.duration) / scene.solver.time_step);
}

}  // namespace fascia
