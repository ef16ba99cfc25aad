#include "app/window/parts/real_time_clock.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// [s] a longer gap means that a window was moved or a file was read, not that the simulation is slow
constexpr double kLongestFrame = 0.25;
constexpr double kStepBudget = 0.03;  // [s] of a frame that steps may take, so that the mouse stays smooth
constexpr int kMostSteps = 1000;      // per frame
constexpr double kMemory = 1.0;       // [s] over which the speed is averaged

}  // namespace

int Pacing::advance(double elapsed, double time_step, double step_cost) {
  elapsed = std::clamp(elapsed, 0.0, kLongestFrame);
  owed_ += elapsed / time_step;
  // One step while the cost is unknown: for a million tets a step takes seconds.
  const double affordable =
      step_cost > 0 ? std::clamp(std::floor(kStepBudget / step_cost), 1.0, double{kMostSteps}) : 1;
  const int steps = static_cast<int>(std::min(std::floor(owed_), affordable));
  owed_ -= steps;
  if (owed_ >= 1) owed_ = kHead;

  const double fade = std::exp(-elapsed / kMemory);
  simulated_ = fade * simulated_ + steps * time_step;
  real_ = fade * real_ + elapsed;
  return steps;
}

void Pacing::restart() { *this = Pacing(); }

}  // namespace fascia
