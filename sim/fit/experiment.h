// Simulates a scene as it was measured, by the reference solver: in motion, or as static equilibria at the times of the
// measurement, and reads from it what the measurement has.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/contact/tool_load.h"
#include "sim/fit/measured/measurement.h"
#include "sim/integrators/stage.h"
#include "sim/model/grab_spring.h"
#include "sim/model/state.h"
#include "sim/scene/scene.h"

namespace fascia {

class Experiment {
 public:
  /// `is_static`: equilibria instead of motion. `end`: when shapes and values without a time are taken in motion [s].
  Experiment(std::vector<Measurement> measurements, bool is_static, double end, std::stop_token stop);

  /// What is observed at one time.
  struct Moment {
    double time = 0;  // [s]
    bool last = false;
    State state;
    std::vector<GrabSpring> springs = {};
    std::vector<ToolLoad> loads = {};
    std::size_t stages = 0;  // of a motion, that lead to it
  };
  /// A stage of a time integrator as it was simulated.
  struct Stage {
    IntegratorStage stage;
    double step_end;  // [s] of the step that it is a part of
    State before;
  };
  struct Response {
    Eigen::VectorXd values;  // measurement by measurement: its curves, then its shapes [N], [m]
    std::vector<Moment> moments;
    std::vector<Stage> stages;  // of a motion without contact, unless they need too much memory
  };
  /// None where the simulation does not converge or is stopped.
  std::optional<Response> run(const Scene& scene, const Model& model) const;

  /// The values of moments in ascending order of time: those between two of them are interpolated.
  Eigen::VectorXd values_of(const Model& model, const std::vector<Moment>& moments) const;
  /// The springs of the scene's grabs at a moment.
  static std::vector<GrabSpring> springs_at(const Model& model, const Moment& moment);

  /// (simulated - measured) / noise, times the root of the weight.
  Eigen::VectorXd residuals(const Eigen::VectorXd& values) const;
  Eigen::VectorXd scales() const;  // what residuals() multiplies differences by
  const std::vector<Measurement>& measurements() const { return measurements_; }
  bool is_static() const { return static_; }

 private:
  std::optional<Response> equilibria(const Scene& scene, const Model& model) const;
  std::optional<Response> motion(const Scene& scene, const Model& model) const;

  std::vector<Measurement> measurements_;
  bool static_;
  double end_;
  std::stop_token stop_;
  std::vector<double> times_;  // of all curves, ascending
  bool has_end_ = false;       // whether anything is measured at the end
  Eigen::VectorXd measured_;
};

}  // namespace fascia
