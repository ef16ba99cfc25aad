#include "app/simulation.h"

#include <cmath>

#include "app/drawn_surface.h"
#include "sim/error.h"

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
  if (!reference_) {
    gpu_->step();
    return;
  }
  newton_report_ = reference_->step(reference_state_);
  if (gpu_) gpu_->upload(reference_state_);
}

void Simulation::reset() {
  if (reference_) reference_state_ = reference::initial_state(model);
  if (gpu_) gpu_->reset();
}

double Simulation::time() const { return reference_ ? reference_state_.time : gpu_->time(); }

reference::NewtonReport Simulation::solve_static() {
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

reference::State Simulation::state() const { return reference_ ? reference_state_ : gpu_->download(); }

long steps_to_run(const CommonOptions& options, const Scene& scene) {
  if (options.steps) return *options.steps;
  return std::lround(options.time.value_or(scene.duration) / scene.solver.time_step);
}

}  // namespace fascia
