#include "sim/output/measured_samples.h"

#include <map>

namespace fascia {
namespace {

Sample unknown_at(double time, std::size_t tools) {
  const Eigen::Vector3d unknown = Eigen::Vector3d::Constant(Sample::kUnknown);
  Sample sample;
  sample.time = time;
  for (double* value : {&sample.kinetic, &sample.elastic, &sample.gravitational, &sample.volume_ratio,
                        &sample.min_det_f, &sample.max_strain, &sample.max_von_mises})
    *value = Sample::kUnknown;
  sample.momentum = sample.reaction = sample.grab = unknown;
  sample.tools.resize(tools);
  for (ToolLoad& load : sample.tools) {
    load.force = load.torque = unknown;
    load.normal = Sample::kUnknown;
  }
  return sample;
}

void set(Eigen::Vector3d& force, int axis, double value) {
  if (!force.allFinite()) force.setZero();
  force[axis] = value;
}

void set(Sample& sample, const Measurand& measurand, double value) {
  using Kind = Measurand::Kind;
  if (measurand.kind == Kind::vertex) sample.probe[measurand.axis] = value;
  if (measurand.kind == Kind::reaction) set(sample.reaction, measurand.axis, value);
  if (measurand.kind == Kind::grab) set(sample.grab, measurand.axis, value);
  if (measurand.kind == Kind::contact) set(sample.tools[measurand.index].force, measurand.axis, value);
}

}  // namespace

std::vector<Sample> measured_samples(const Measurement& measurement, std::size_t tools, std::uint32_t probe) {
  std::map<double, Sample> by_time;
  for (const MeasuredCurve& curve : measurement.curves) {
    const Measurand& measurand = curve.measurand;
    if (measurand.kind == Measurand::Kind::support) continue;
    if (measurand.kind == Measurand::Kind::vertex && measurand.index != probe) continue;
    for (std::size_t i = 0; i < curve.times.size(); ++i)
      set(by_time.try_emplace(curve.times[i], unknown_at(curve.times[i], tools)).first->second, measurand,
          curve.values[i]);
  }
  std::vector<Sample> samples;
  for (auto& [time, sample] : by_time) samples.push_back(std::move(sample));
  return samples;
}

}  // namespace fascia
