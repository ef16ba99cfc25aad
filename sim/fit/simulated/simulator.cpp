#include "sim/fit/simulated/simulator.h"

#include <algorithm>
#include <cmath>

namespace fascia {

ObservedSteps::ObservedSteps(const Schedule& schedule, double time_step) {
  double end = schedule.times.empty() ? 0 : schedule.times.back();
  if (schedule.has_end) end = std::max(end, schedule.end);
  const auto steps_until = [&](double time) { return static_cast<long>(std::ceil(time / time_step - 1e-9)); };
  count = std::max(1L, steps_until(end));
  numbers.insert(count);
  for (const double time : schedule.times) numbers.insert({steps_until(time), std::max(0L, steps_until(time) - 1)});
}

std::vector<GrabSpring> springs_at(const Model& model, const Moment& moment) {
  return moment.last ? with_grabs_at_last({}, model.grabs) : with_grabs({}, model.grabs, moment.time);
}

std::vector<Moment> static_moments(const Model& model, const Schedule& schedule) {
  std::vector<Moment> moments;
  for (const double time : schedule.times) moments.push_back({time, false, {}});
  if (schedule.has_end) moments.push_back({0, true, {}});
  for (Moment& moment : moments) moment.springs = springs_at(model, moment);
  return moments;
}

}  // namespace fascia
