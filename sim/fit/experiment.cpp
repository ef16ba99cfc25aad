#include "sim/fit/experiment.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/fit/measured/shape_distance.h"
#include "sim/integrators/integrator.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Moment = Experiment::Moment;

// Farther from equilibrium, a state is no result.
constexpr double kSolved = 1e-6;  // relative residual

// The vectors of a moment, each computed once and only where a curve asks for it.
class Reading {
 public:
  Reading(const Model& model, const Moment& moment) : model_(model), moment_(moment) {}

  double operator()(const Measurand& measurand) {
    using Kind = Measurand::Kind;
    switch (measurand.kind) {
      case Kind::reaction: {
        Vector3d sum = Vector3d::Zero();
        for (const reference::Support& support : supports()) sum += support.force;
        return sum[measurand.axis];
      }
      case Kind::support:
        return supports()[measurand.index].force[measurand.axis];
      case Kind::grab: {
        Vector3d sum = Vector3d::Zero();
        for (const GrabSpring& spring : moment_.springs)
          sum += spring.stiffness * (spring.target - moment_.state.displacement[spring.vertex]);
        return sum[measurand.axis];
      }
      case Kind::contact:
        return moment_.loads[measurand.index].force[measurand.axis];
      case Kind::vertex:
        break;
    }
    return moment_.state.displacement[measurand.index][measurand.axis];
  }

 private:
  const std::vector<reference::Support>& supports() {
    if (!supports_) supports_ = reference::support_forces(model_, moment_.state);
    return *supports_;
  }

  const Model& model_;
  const Moment& moment_;
  std::optional<std::vector<reference::Support>> supports_;
};

// Of the stages that are kept for their rates.
constexpr double kMostBytes = 2e9;

bool is_worth_keeping(const Model& model, const SolverSettings& settings, long steps) {
  constexpr double kVectors = 4;  // of a State at every vertex
  const double stages = static_cast<double>(steps) * settings.substeps * info_of(settings.integrator).stages;
  return !model.has_contact() &&
         stages * kVectors * sizeof(Vector3d) * static_cast<double>(model.rest_positions.size()) < kMostBytes;
}

// NewtonSolver::step() of a model without contact, which keeps its stages.
reference::NewtonReport step_by_stages(reference::NewtonSolver& solver, const SolverSettings& settings, State& state,
                                       std::vector<Experiment::Stage>& stages) {
  reference::NewtonReport report;
  report.converged = true;
  const double end = state.time + settings.time_step;
  for (int k = 0; k < settings.substeps; ++k) {
    for (const IntegratorStage& stage : stages_of(settings.integrator, settings.substep(), state.earlier.step)) {
      stages.push_back({stage, end, state});
      const reference::NewtonReport part = solver.solve(stage, state);
      report.converged = report.converged && part.converged;
      report.relative_residual = std::max(report.relative_residual, part.relative_residual);
    }
    state.earlier.step = settings.substep();
  }
  if (!info_of(settings.integrator).multistep) state.earlier = {};
  return report;
}

bool is_finite(const State& state) {
  return std::all_of(state.displacement.begin(), state.displacement.end(),
                     [](const Vector3d& u) { return u.allFinite(); });
}

}  // namespace

Experiment::Experiment(std::vector<Measurement> measurements, bool is_static, double end, std::stop_token stop)
    : measurements_(std::move(measurements)), static_(is_static), end_(end), stop_(std::move(stop)) {
  std::set<double> times;
  std::vector<double> measured;
  for (const Measurement& measurement : measurements_) {
    for (const MeasuredCurve& curve : measurement.curves) {
      times.insert(curve.times.begin(), curve.times.end());
      has_end_ = has_end_ || curve.times.empty();
      measured.insert(measured.end(), curve.values.begin(), curve.values.end());
    }
    has_end_ = has_end_ || !measurement.shapes.empty();
    for (const MeasuredShape& shape : measurement.shapes) measured.resize(measured.size() + shape.value_count(), 0);
  }
  times_.assign(times.begin(), times.end());
  measured_ = Eigen::Map<const VectorXd>(measured.data(), static_cast<Eigen::Index>(measured.size()));
}

VectorXd Experiment::scales() const {
  VectorXd scales(measured_.size());
  Eigen::Index i = 0;
  const auto add = [&](std::size_t count, double noise, double weight) {
    for (std::size_t k = 0; k < count; ++k) scales[i++] = std::sqrt(weight) / noise;
  };
  for (const Measurement& measurement : measurements_) {
    for (const MeasuredCurve& curve : measurement.curves) add(curve.values.size(), curve.noise, measurement.weight);
    for (const MeasuredShape& shape : measurement.shapes) add(shape.value_count(), shape.noise, measurement.weight);
  }
  return scales;
}

VectorXd Experiment::residuals(const VectorXd& values) const { return (values - measured_).cwiseProduct(scales()); }

std::vector<GrabSpring> Experiment::springs_at(const Model& model, const Moment& moment) {
  return moment.last ? with_grabs_at_last({}, model.grabs) : with_grabs({}, model.grabs, moment.time);
}

VectorXd Experiment::values_of(const Model& model, const std::vector<Moment>& moments) const {
  std::vector<Reading> readings;
  for (const Moment& moment : moments) readings.emplace_back(model, moment);
  const auto value_at = [&](const Measurand& measurand, double time) {
    const auto after = std::lower_bound(moments.begin(), moments.end(), time,
                                        [](const Moment& m, double t) { return m.time < t && !m.last; });
    const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(after - moments.begin()), moments.size() - 1);
    if (k == 0 || moments[k].time <= time) return readings[k](measurand);
    const double share = (time - moments[k - 1].time) / (moments[k].time - moments[k - 1].time);
    return (1 - share) * readings[k - 1](measurand) + share * readings[k](measurand);
  };
  VectorXd values(measured_.size());
  Eigen::Index i = 0;
  for (const Measurement& measurement : measurements_) {
    for (const MeasuredCurve& curve : measurement.curves) {
      if (curve.times.empty()) values[i++] = readings.back()(curve.measurand);
      for (const double time : curve.times) values[i++] = value_at(curve.measurand, time);
    }
    for (const MeasuredShape& shape : measurement.shapes)
      for (const double d : distances_to(shape, model, moments.back().state.displacement)) values[i++] = d;
  }
  return values;
}

std::optional<Experiment::Response> Experiment::run(const Scene& scene, const Model& model) const {
  return static_ ? equilibria(scene, model) : motion(scene, model);
}

std::optional<Experiment::Response> Experiment::equilibria(const Scene& scene, const Model& model) const {
  Response response;
  for (const double time : times_) response.moments.push_back({time, false, {}});
  if (has_end_) response.moments.push_back({0, true, {}});
  reference::NewtonSolver solver(model, scene.solver, stop_);
  State state = initial_state(model);
  for (Moment& moment : response.moments) {
    moment.springs = springs_at(model, moment);
    solver.set_springs(moment.springs);
    const auto until = moment.last ? std::nullopt : std::optional(moment.time);
    const reference::NewtonReport report = solver.solve_static(state, 0, until);
    if (!(report.converged || report.relative_residual < kSolved) || !is_finite(state)) return std::nullopt;
    moment.state = state;
    moment.loads = solver.tool_loads();
  }
  response.values = values_of(model, response.moments);
  return response;
}

std::optional<Experiment::Response> Experiment::motion(const Scene& scene, const Model& model) const {
  const double step = scene.solver.time_step;
  double end = times_.empty() ? 0 : times_.back();
  if (has_end_) end = std::max(end, end_);
  const auto steps_until = [&](double time) { return static_cast<long>(std::ceil(time / step - 1e-9)); };
  const long steps = std::max(1L, steps_until(end));
  std::set<long> wanted{steps};
  for (const double time : times_) wanted.insert({steps_until(time), std::max(0L, steps_until(time) - 1)});

  reference::NewtonSolver solver(model, scene.solver, stop_);
  State state = initial_state(model);
  Response response;
  const auto observe = [&](long number, double time, std::vector<GrabSpring> springs) {
    if (wanted.contains(number))
      response.moments.push_back({time, false, state, std::move(springs), solver.tool_loads(), response.stages.size()});
  };
  observe(0, 0, {});
  const bool keeps = is_worth_keeping(model, scene.solver, steps);
  for (long number = 1; number <= steps; ++number) {
    const double time = state.time + step;
    std::vector<GrabSpring> springs = with_grabs({}, model.grabs, time);
    solver.set_springs(springs);
    const reference::NewtonReport report =
        keeps ? step_by_stages(solver, scene.solver, state, response.stages) : solver.step(state);
    if (stop_.stop_requested() || !(report.converged || report.relative_residual < kSolved) || !is_finite(state))
      return std::nullopt;
    observe(number, time, std::move(springs));
  }
  response.values = values_of(model, response.moments);
  return response;
}

}  // namespace fascia
