#include "sim/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>

#include "base/error.h"
#include "base/suggest.h"
#include "base/text.h"
#include "sim/fit/simulated/in_parallel.h"

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Stopped {};

double rms(const VectorXd& residuals) {
  return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
}

// Of the values in the weights of the residuals. Those of shapes are distances, whose size is that at the start.
double magnitude_of(const Misfit& misfit, const Misfit::Point& point, double start_misfit) {
  return std::max(point.response.values.cwiseProduct(misfit.experiment().scales()).norm(),
                  start_misfit * std::sqrt(static_cast<double>(misfit.value_count())));
}

// The simulation is the measurement, but for digits that no measurement has. The solver would go on to rounding.
bool is_exact(const Misfit& misfit, const Misfit::Point& point, double start_misfit) {
  constexpr double kExact = 1e-8;
  return point.residuals.norm() < kExact * magnitude_of(misfit, point, start_misfit);
}

std::string described(const std::vector<Parameter>& parameters, const VectorXd& inner) {
  std::string text;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    text += (p == 0 ? "" : ", ") + parameters[p].key + "=" + number(parameters[p].value(inner[static_cast<Index>(p)]));
  return text;
}

// The misfit as Eigen's solver asks for it: at distances from the start, so that its trust region is in units of the
// inner coordinates.
class Functor {
 public:
  using Scalar = double;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;

  /// `keep` is called with every point that is the best so far.
  Functor(const Misfit& misfit, Misfit::Point start, double start_misfit, const FitOptions& options,
          std::function<void(const Misfit::Point&)> keep)
      : misfit_(misfit),
        options_(options),
        start_misfit_(start_misfit),
        keep_(std::move(keep)),
        start_(start.inner),
        last_(std::move(start)),
        best_(last_) {
    keep_(best_);
  }

  int inputs() const { return static_cast<int>(start_.size()); }
  int values() const { return static_cast<int>(misfit_.value_count()); }

  int operator()(const VectorXd& moved, VectorXd& residuals) {
    const VectorXd inner = start_ + moved;
    if (inner == last_.inner) {
      residuals = last_.residuals;
      return 0;
    }
    std::optional<Misfit::Point> point = misfit_.at(inner);
    if (options_.stop.stop_requested()) throw Stopped();
    say(inner, point);
    if (!point) {
      constexpr double kRefused = 1e3;  // times the misfit: the solver tries a shorter step
      residuals = kRefused * (last_.residuals.array().abs() + last_.residuals.norm()).matrix();
      return 0;
    }
    residuals = point->residuals;
    last_ = std::move(*point);
    if (last_.residuals.squaredNorm() <= best_.residuals.squaredNorm()) {
      best_ = last_;
      keep_(best_);
    }
    return is_exact() ? -1 : 0;
  }
  // Called where the last step was accepted.
  int df(const VectorXd& moved, MatrixXd& rates) {
    if (start_ + moved != last_.inner) last_ = best_;
    rates = rates_at(last_);
    return 0;
  }
  const Misfit::Point& best() const { return best_; }
  bool is_exact() const { return fascia::is_exact(misfit_, best_, start_misfit_); }
  const MatrixXd& rates_at(const Misfit::Point& point) {
    if (rates_.size() == 0 || point.inner != rated_) {
      rates_ = misfit_.rates(point);
      rated_ = point.inner;
    }
    if (options_.stop.stop_requested()) throw Stopped();
    return rates_;
  }

 private:
  void say(const VectorXd& inner, const std::optional<Misfit::Point>& point) const {
    if (!options_.say) return;
    options_.say("simulation " + std::to_string(misfit_.simulations()) + ": " +
                 (point ? "misfit " + number(rms(point->residuals)) : std::string("does not converge")) + ", " +
                 described(misfit_.tuned().parameters(), inner));
  }

  const Misfit& misfit_;
  const FitOptions& options_;
  const double start_misfit_;  // with the scene's own values
  const std::function<void(const Misfit::Point&)> keep_;
  const VectorXd start_;
  Misfit::Point last_, best_;
  MatrixXd rates_;  // at rated_
  VectorXd rated_;
};

// A number in (0, 1) of the Halton sequence (1960).
double halton(int index, int base) {
  double share = 1, sum = 0;
  for (; index > 0; index /= base) {
    share /= base;
    sum += share * (index % base);
  }
  return sum;
}

VectorXd swept(const std::vector<Parameter>& parameters, int index) {
  constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
  VectorXd inner(static_cast<Index>(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const Parameter& parameter = parameters[p];
    const double share = halton(index, kPrimes[p % std::size(kPrimes)]);
    const double middle = parameter.natural(parameter.start);
    const double reach = parameter.logarithmic ? std::log(10) : std::max(1.0, std::abs(parameter.start));
    const double low = parameter.bounds ? parameter.natural(parameter.bounds->low) : middle - reach;
    const double high = parameter.bounds ? parameter.natural(parameter.bounds->high) : middle + reach;
    inner[static_cast<Index>(p)] = parameter.inner(parameter.from_natural(low + share * (high - low)));
  }
  return inner;
}

Misfit::Point best_of_sweep(const Misfit& misfit, Misfit::Point start, const FitOptions& options) {
  std::vector<std::optional<Misfit::Point>> points(static_cast<std::size_t>(options.sweep));
  in_parallel(
      points.size(),
      [&](std::size_t i) {
        if (!options.stop.stop_requested())
          points[i] = misfit.at(swept(misfit.tuned().parameters(), static_cast<int>(i) + 1));
      },
      misfit.experiment().simulator().most_threads());
  for (std::optional<Misfit::Point>& point : points)
    if (point && point->residuals.squaredNorm() < start.residuals.squaredNorm()) start = std::move(*point);
  if (options.say && options.sweep > 0)
    options.say("sweep: the best of " + plural(points.size() + 1, "simulation") + " has the misfit " +
                number(rms(start.residuals)) + ", " + described(misfit.tuned().parameters(), start.inner));
  return start;
}

std::string reason_of(Eigen::LevenbergMarquardtSpace::Status status, const FitOptions& options) {
  using namespace Eigen::LevenbergMarquardtSpace;
  if (status == TooManyFunctionEvaluation)
    return "no minimum after " + std::to_string(options.most_simulations) + " simulations";
  if (status == ImproperInputParameters || status == UserAsked || status == NotStarted)
    return "the solver did not begin";
  return "";
}

// The names of what was measured: "the measurement (reaction_y, probe_y)".
std::string subject_of(const Experiment& experiment) {
  std::vector<std::string> names;
  for (const Measurement& measurement : experiment.measurements()) {
    for (const MeasuredCurve& curve : measurement.curves)
      if (std::find(names.begin(), names.end(), curve.name) == names.end()) names.push_back(curve.name);
    if (!measurement.shapes.empty()) names.push_back("shape");
  }
  return "the measurement (" + join(names) + ")";
}

// Curves that the scene's own values miss by orders of magnitude, as wrong units do.
std::vector<std::string> doubtful_units(const Experiment& experiment, const VectorXd& simulated) {
  constexpr double kDoubtful = 100;
  std::vector<std::string> doubts;
  Index row = 0;
  for (const Measurement& measurement : experiment.measurements()) {
    for (const MeasuredCurve& curve : measurement.curves) {
      const auto count = static_cast<Index>(curve.values.size());
      const double measured = Eigen::Map<const VectorXd>(curve.values.data(), count).cwiseAbs().maxCoeff();
      const double ratio = measured / simulated.segment(row, count).cwiseAbs().maxCoeff();
      if (std::isfinite(ratio) && (ratio > kDoubtful || (ratio > 0 && ratio < 1 / kDoubtful)))
        doubts.push_back(curve.name + " of " + measurement.file.filename().string() + " is " + number(ratio) +
                         " times as large as with the scene's own values: is its unit right?");
      row += count;
    }
    for (const MeasuredShape& shape : measurement.shapes) row += static_cast<Index>(shape.value_count());
  }
  return doubts;
}

// How far a profile goes at either side where no standard error says it [natural coordinate].
double tenth_of(const Parameter& parameter, double value) {
  constexpr double kShare = 0.1;
  if (parameter.logarithmic) return kShare;
  return kShare * (parameter.bounds ? parameter.bounds->high - parameter.bounds->low : std::max(1.0, std::abs(value)));
}

std::vector<MisfitProfile> profiles_of(const Misfit& misfit, const Misfit::Point& minimum, const Estimates& estimates,
                                       bool exact, const FitOptions& options) {
  const std::vector<Parameter>& parameters = misfit.tuned().parameters();
  const bool of_errors = options.noise_known || (!exact && std::isfinite(estimates.spread));
  struct Job {
    std::size_t profile;
    VectorXd inner;
    double value = 0, misfit = std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<Job> jobs;
  for (std::size_t p = 0; p < parameters.size() && options.profile > 0; ++p) {
    const auto column = static_cast<Index>(p);
    const double cofactor = estimates.cofactors(column, column), middle = minimum.inner[column];
    if (!estimates.parameters[p].determined || !(cofactor > 0)) continue;
    const double reach =
        of_errors ? 3 * estimates.spread * std::sqrt(cofactor)
                  : tenth_of(parameters[p], parameters[p].value(middle)) / parameters[p].natural_rate(middle);
    for (int k = -options.profile; k <= options.profile; ++k) {
      // The others follow as the covariance says.
      const double away = reach * k / options.profile;
      const VectorXd inner = minimum.inner + away / cofactor * estimates.cofactors.col(column);
      jobs.push_back({p, inner, parameters[p].value(inner[column])});
      if (k == 0) jobs.back().misfit = rms(minimum.residuals);
    }
  }
  in_parallel(
      jobs.size(),
      [&](std::size_t i) {
        if (!std::isnan(jobs[i].misfit) || options.stop.stop_requested()) return;
        if (const auto point = misfit.at(jobs[i].inner)) jobs[i].misfit = rms(point->residuals);
      },
      misfit.experiment().simulator().most_threads());
  std::vector<MisfitProfile> profiles;
  for (const Job& job : jobs) {
    if (profiles.empty() || profiles.back().parameter != job.profile)
      profiles.push_back({job.profile, {}, {}, of_errors});
    profiles.back().values.push_back(job.value);
    profiles.back().misfits.push_back(job.misfit);
  }
  return profiles;
}

}  // namespace

FitResult fit(const TunedScene& tuned, const Experiment& experiment, const FitOptions& options) {
  const Misfit misfit(tuned, experiment);
  const std::vector<Parameter>& parameters = tuned.parameters();
  const std::vector<double> start = options.earlier ? options.earlier->inner : tuned.start();
  const long simulated_before = options.earlier ? options.earlier->simulations : 0;
  const auto count = static_cast<Index>(parameters.size());
  FitResult result;
  result.scene = tuned.scene();
  if (misfit.value_count() < count)
    throw Error("--free",
                "has " + plural(parameters.size(), "parameter") + " for " +
                    plural(static_cast<std::size_t>(misfit.value_count()), "measured value"),
                "expected at least as many values");
  const auto stopped = [&] {
    result.interrupted = true;
    result.reason = "interrupted";
    return result;
  };
  std::optional<Misfit::Point> first = misfit.at(Eigen::Map<const VectorXd>(start.data(), count));
  if (options.stop.stop_requested()) return stopped();
  if (!first)
    throw Error(tuned.scene().file.string(), "does not converge with its own values",
                "expected a scene that fascia run --reference simulates");
  result.start_misfit = options.earlier ? options.earlier->start_misfit : rms(first->residuals);
  if (options.say)
    options.say("simulation 1: misfit " + number(rms(first->residuals)) + ", " + described(parameters, first->inner));
  const std::vector<std::string> doubts = doubtful_units(experiment, first->response.values);
  for (const std::string& doubt : doubts)
    if (options.say) options.say(doubt);
  const auto keep = [&](const Misfit::Point& point) {
    if (options.keep)
      options.keep(
          {{point.inner.begin(), point.inner.end()}, simulated_before + misfit.simulations(), result.start_misfit});
  };
  Misfit::Point begin = options.earlier ? std::move(*first) : best_of_sweep(misfit, std::move(*first), options);
  if (options.stop.stop_requested()) return stopped();
  Functor functor(misfit, std::move(begin), result.start_misfit, options, keep);

  Eigen::LevenbergMarquardt<Functor> solver(functor);
  solver.parameters.factor = 1.5;  // the first step at most, in inner coordinates
  solver.parameters.ftol = 1e-6;
  solver.parameters.xtol = 1e-8;
  // The cosine between residuals and rates at some 0.03 standard errors from the minimum: nearer is below the noise.
  solver.parameters.gtol = 0.03 / std::sqrt(static_cast<double>(misfit.value_count()));
  solver.parameters.maxfev = options.most_simulations;
  solver.useExternalScaling = true;
  solver.diag = VectorXd::Ones(count);
  VectorXd moved = VectorXd::Zero(count);
  try {
    const Eigen::LevenbergMarquardtSpace::Status status = solver.minimize(moved);
    if (!functor.is_exact()) result.reason = reason_of(status, options);
    result.converged = result.reason.empty();
    const Misfit::Point& minimum = functor.best();
    result.misfit = rms(minimum.residuals);
    result.simulated = minimum.response.values;
    result.exact_rates = misfit.exact(minimum);
    const double magnitude = magnitude_of(misfit, minimum, result.start_misfit);
    result.estimates = estimate(parameters, {minimum.inner, minimum.residuals, functor.rates_at(minimum),
                                             options.noise_known, magnitude, subject_of(experiment)});
    if (options.stop.stop_requested()) return stopped();
    result.simulations = simulated_before + misfit.simulations();
    result.scene = tuned.at({minimum.inner.begin(), minimum.inner.end()}).scene;
    if (result.converged) result.profiles = profiles_of(misfit, minimum, result.estimates, functor.is_exact(), options);
    result.profile_simulations = simulated_before + misfit.simulations() - result.simulations;
    if (options.stop.stop_requested()) return stopped();
  } catch (const Stopped&) {
    return stopped();
  }
  if (result.converged && !result.estimates.determined()) {
    result.converged = false;
    result.reason = result.estimates.warnings.front();
  }
  result.estimates.warnings.insert(result.estimates.warnings.begin(), doubts.begin(), doubts.end());
  return result;
}

}  // namespace fascia
