// The residuals of a fit as a function of its parameters' inner coordinates (sim/fit/parameter.h), with their rates.
#pragma once
#include <Eigen/Core>
#include <atomic>
#include <optional>

#include "sim/fit/experiment.h"
#include "sim/fit/tuned_scene.h"

namespace fascia {

class Misfit {
 public:
  Misfit(const TunedScene& tuned, const Experiment& experiment) : tuned_(tuned), experiment_(experiment) {}

  struct Point {
    Eigen::VectorXd inner;      // [parameter]
    Eigen::VectorXd residuals;  // of the measured values, then of the priors
    Experiment::Response response;
  };
  /// One simulation. None where the scene has no such values or the simulation does not converge.
  std::optional<Point> at(const Eigen::VectorXd& inner) const;

  /// d residuals/d inner [residual][parameter]. Without contact by implicit differentiation (sim/fit/moved_moments.h),
  /// which is no simulation; else, and for parameters that change the mesh, by differences, one simulation per
  /// parameter.
  Eigen::MatrixXd rates(const Point& point) const;
  /// Whether rates() makes no further simulation.
  bool exact(const Point& point) const;

  Eigen::Index value_count() const;  // of residuals
  Eigen::Index prior_count() const;
  long simulations() const { return simulations_; }
  const TunedScene& tuned() const { return tuned_; }
  const Experiment& experiment() const { return experiment_; }

 private:
  bool has_tangent(const Point& point, std::size_t parameter) const;
  TunedScene::Built built(const Eigen::VectorXd& inner) const;
  void add_tangents(const Point& point, Eigen::MatrixXd& rates) const;
  void add_differences(const Point& point, Eigen::MatrixXd& rates) const;

  const TunedScene& tuned_;
  const Experiment& experiment_;
  mutable std::atomic<long> simulations_ = 0;
};

}  // namespace fascia
