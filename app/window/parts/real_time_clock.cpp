#include "app/window/parts/real_time_clock.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// [s] a longer gap means that a window was moved or a file was read, not that the simulation is slow
constexpr double kLongestFrame = 0.25;
// [s] of a frame that steps may take: twice as long as the rest of it, since slow pictures must not slow the
// tissue, too, but never so long that the mouse stutters
constexpr double kLeastBudget = 0.03, kMostBudget = 0.12, kStepsPerPicture = 2;
constexpr double kNewest = 0.2;   // weight of the last frame in the average of the rest
constexpr int kMostSteps = 1000;  // per frame
constexpr double kMemory = 1.0;   // [s] over which the speed is averaged

}  // namespace

int Pacing::advance(double elapsed, double time_step, double step_cost) {
  const double whole = std::min(std::max(elapsed, 0.0), kLongestFrame + steps_ * step_cost);  // slow steps are no gap
  elapsed = std::clamp(elapsed, 0.0, kLongestFrame);
  owed_ += elapsed / time_step;
  picture_ += kNewest * (std::max(0.0, elapsed - steps_ * step_cost) - picture_);
  const double budget = std::clamp(kStepsPerPicture * picture_, kLeastBudget, kMostBudget);
  // One step while the cost is unknown: for a million tets a step takes seconds.
  const double affordable = step_cost > 0 ? std::clamp(std::floor(budget / step_cost), 1.0, double{kMostSteps}) : 1;
  const int steps = static_cast<int>(std::min(std::floor(owed_), affordable));
  owed_ -= steps;
  steps_ = steps;
  if (owed_ >= 1) owed_ = kHead;

  const double fade = std::exp(-whole / kMemory);
  simulated_ = fade * simulated_ + steps * time_step;
  real_ = fade * real_ + whole;
  return steps;
}

void Pacing::restart() { *this = Pacing(); }

}  // namespace fascia
