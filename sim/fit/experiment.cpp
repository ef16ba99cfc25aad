#include "sim/fit/experiment.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/fit/measured/shape_distance.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

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
    if (!supports_) supports_ = reference::support_forces(model_, moment_.state, moment_.contact);
    return *supports_;
  }

  const Model& model_;
  const Moment& moment_;
  std::optional<std::vector<reference::Support>> supports_;
};

}  // namespace

Experiment::Experiment(std::vector<Measurement> measurements, bool is_static, double end, const Simulator& simulator)
    : measurements_(std::move(measurements)), simulator_(simulator), schedule_{is_static, {}, false, end} {
  std::set<double> times;
  std::vector<double> measured;
  for (const Measurement& measurement : measurements_) {
    for (const MeasuredCurve& curve : measurement.curves) {
      times.insert(curve.times.begin(), curve.times.end());
      schedule_.has_end = schedule_.has_end || curve.times.empty();
      measured.insert(measured.end(), curve.values.begin(), curve.values.end());
    }
    schedule_.has_end = schedule_.has_end || !measurement.shapes.empty();
    for (const MeasuredShape& shape : measurement.shapes) measured.resize(measured.size() + shape.value_count(), 0);
  }
  schedule_.times.assign(times.begin(), times.end());
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
  std::optional<Course> course = simulator_.run(scene, model, schedule_);
  if (!course) return std::nullopt;
  Response response{std::move(*course), {}};
  response.values = values_of(model, response.moments);
  return response;
}

}  // namespace fascia
