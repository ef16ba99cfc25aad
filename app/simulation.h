// An open scene being simulated, by the GPU solver or by the double-precision reference. Draws nothing.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "app/options.h"
#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "sim/scene.h"

namespace fascia {

class Simulation {
 public:
  /// `programs` null: no GPU at all, which only the reference solver can do without. Throws Error.
  Simulation(Scene scene, gl::ProgramCache* programs, bool use_reference);

  Scene scene;  // as opened; materials and solver settings follow the changes made here
  Model model;

  void step();
  void reset();
  double time() const;
  /// Static equilibrium, by the reference solver to 1e-10 or by the GPU to 1e-5, or to solver.tolerance if that is given. Throws Error
  /// when the reference solver does not reach it; the GPU's report tells how far float32 went.
  reference::NewtonReport solve_static();

  void set_settings(const SolverSettings& settings);
  void set_material(std::size_t index, const Material& material);  // of model.materials
  void set_gravity(const Eigen::Vector3d& gravity);

  /// Per substep, of all steps so far on average: fewer than asked for where solver.tolerance or solver.frame_budget bind.
  double mean_iterations() const;
  /// How many of the iterations the next step gets: fewer than asked for where solver.frame_budget binds.
  int iterations_granted() const { return gpu_ && !reference_ ? gpu_->settings().iterations : scene.solver.iterations; }

  reference::State state() const;
  GpuSolver* gpu() { return gpu_.get(); }  // null without a GPU
  bool uses_reference() const { return reference_ != nullptr; }
  const reference::NewtonReport& newton_report() const { return newton_report_; }

 private:
  void step_within_budget();

  std::unique_ptr<GpuSolver> gpu_;
  std::optional<reference::State> equilibrium_;  // of solve_static() on the GPU, to more digits than float32 holds; until the next step
  double ms_per_iteration_ = 0;  // of the GPU, a running mean over steps; 0: not measured
  std::unique_ptr<reference::NewtonSolver> reference_;
  reference::State reference_state_;
  reference::NewtonReport newton_report_;
};

/// Steps that a command makes: --steps, else --time, else the scene's duration.
long steps_to_run(const CommonOptions& options, const Scene& scene);

}  // namespace fascia
