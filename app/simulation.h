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
  /// Static equilibrium by the reference solver. Throws Error when it is not reached.
  reference::NewtonReport solve_static();

  void set_settings(const SolverSettings& settings);
  void set_material(std::size_t index, const Material& material);  // of model.materials
  void set_gravity(const Eigen::Vector3d& gravity);

  reference::State state() const;
  GpuSolver* gpu() { return gpu_.get(); }  // null without a GPU
  bool uses_reference() const { return reference_ != nullptr; }
  const reference::NewtonReport& newton_report() const { return newton_report_; }

 private:
  std::unique_ptr<GpuSolver> gpu_;
  std::unique_ptr<reference::NewtonSolver> reference_;
  reference::State reference_state_;
  reference::NewtonReport newton_report_;
};

/// Steps that a command makes: --steps, else --time, else the scene's duration.
long steps_to_run(const CommonOptions& options, const Scene& scene);

}  // namespace fascia
