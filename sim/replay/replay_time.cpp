#include "sim/replay/replay_time.h"

#include <algorithm>
#include <cmath>

namespace fascia {

ReplayTime::ReplayTime(const Replay& replay) : parts_{{0, 0, replay.scene.solver.time_step}} {
  for (const Input& input : replay.inputs) {
    const auto* settings = std::get_if<SolverSettings>(&input.change);
    if (!settings || settings->time_step == parts_.back().time_step) continue;
    if (input.step == parts_.back().step)
      parts_.back().time_step = settings->time_step;
    else
      parts_.push_back({input.step, seconds(input.step), settings->time_step});
  }
}

const ReplayTime::Part& ReplayTime::part_of(long step) const {
  return *std::prev(
      std::upper_bound(parts_.begin() + 1, parts_.end(), step, [](long s, const Part& part) { return s < part.step; }));
}

double ReplayTime::seconds(long steps) const {
  const Part& part = part_of(steps);
  return part.begin + static_cast<double>(steps - part.step) * part.time_step;
}

long ReplayTime::steps(double seconds) const {
  const auto next = std::upper_bound(parts_.begin() + 1, parts_.end(), seconds,
                                     [](double s, const Part& part) { return s < part.begin; });
  const Part& part = *std::prev(next);
  return part.step + std::lround((seconds - part.begin) / part.time_step);
}

double ReplayTime::time_step(long step) const { return part_of(step).time_step; }

double ReplayTime::longest_step() const {
  return std::max_element(parts_.begin(), parts_.end(),
                          [](const Part& a, const Part& b) { return a.time_step < b.time_step; })
      ->time_step;
}

}  // namespace fascia
