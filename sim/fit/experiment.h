// A measurement and the simulations of it: when a scene is observed, what is read from it, and how far that is from
// what was measured.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sim/fit/measured/measurement.h"
#include "sim/fit/simulated/simulator.h"

namespace fascia {

class Experiment {
 public:
  /// `is_static`: equilibria instead of motion. `end`: when shapes and values without a time are taken in motion [s].
  /// `simulator` must outlive the experiment.
  Experiment(std::vector<Measurement> measurements, bool is_static, double end, const Simulator& simulator);

  struct Response : Course {
    Eigen::VectorXd values;  // measurement by measurement: its curves, then its shapes [N], [m]
  };
  /// None where the simulation does not converge or is stopped.
  std::optional<Response> run(const Scene& scene, const Model& model) const;

  /// The values of moments in ascending order of time: those between two of them are interpolated.
  Eigen::VectorXd values_of(const Model& model, const std::vector<Moment>& moments) const;

  /// (simulated - measured) / noise, times the root of the weight.
  Eigen::VectorXd residuals(const Eigen::VectorXd& values) const;
  Eigen::VectorXd scales() const;  // what residuals() multiplies differences by
  const std::vector<Measurement>& measurements() const { return measurements_; }
  const Simulator& simulator() const { return simulator_; }

 private:
  std::vector<Measurement> measurements_;
  const Simulator& simulator_;
  Schedule schedule_;  // of all curves
  Eigen::VectorXd measured_;
};

}  // namespace fascia
