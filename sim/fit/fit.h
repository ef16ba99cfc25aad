// Finds the parameters of a scene with which its simulation meets a measurement: weighted least squares by the method
// of Levenberg and Marquardt (More 1978, as in MINPACK; Eigen's port of it).
#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "sim/fit/estimate.h"
#include "sim/fit/experiment.h"
#include "sim/fit/misfit.h"
#include "sim/fit/tuned_scene.h"

namespace fascia {

/// How far a fit has come.
struct FitProgress {
  std::vector<double> inner;  // [parameter] the best values so far
  long simulations = 0;
  double start_misfit = 0;
};

struct FitOptions {
  int sweep = 0;    // simulations spread over the parameters' ranges before the fit, which begins at the best one
  int profile = 3;  // points of each profile at either side of the minimum
  int most_simulations = 100;
  bool noise_known = false;
  std::stop_token stop = {};
  std::function<void(const std::string&)> say = {};   // a line of progress
  std::optional<FitProgress> earlier = {};            // of an interrupted fit: begins there, without a sweep
  std::function<void(const FitProgress&)> keep = {};  // called with every point that is better than those before
};

/// The misfit along one parameter, the others where they follow it to first order.
struct MisfitProfile {
  std::size_t parameter;
  std::vector<double> values;   // ascending, the minimum among them
  std::vector<double> misfits;  // root mean square of the weighted residuals; NaN: not simulated
  bool of_errors = true;  // up to three standard errors at either side; else, where the residuals say nothing of the
                          // noise, a tenth of the value, or of its range
};

struct FitResult {
  bool converged = false;
  bool interrupted = false;
  std::string reason;  // why not converged
  Estimates estimates;
  Eigen::VectorXd simulated;  // Experiment::Response::values at the minimum
  double misfit = 0;          // root mean square of the weighted residuals
  double start_misfit = 0;
  long simulations = 0;          // of the fit, with those of its differences and its sweep
  long profile_simulations = 0;  // beside them
  bool exact_rates = false;      // by implicit differentiation
  std::vector<MisfitProfile> profiles;
  Scene scene;  // with the fitted values
};

/// Throws Error where the simulation fails with the scene's own values, and for fewer measured values than parameters.
FitResult fit(const TunedScene& tuned, const Experiment& experiment, const FitOptions& options);

}  // namespace fascia
