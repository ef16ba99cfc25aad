#include "sim/model/rest_detector.h"

#include <algorithm>

namespace fascia {
namespace {

constexpr double kQuiet = 0.25;  // [s] longer than a pendulum stands still at its turning point
constexpr int kLooks = 2;        // minimum, for steps of any length
// Of a displacement, in float32: a converged iteration was never observed to move it by more than half of this.
constexpr double kRounding = 6e-6;

}  // namespace

bool is_still(double way, double seconds, double displacement, const SolverSettings& settings, double size) {
  return way <= settings.rest_speed * size * seconds + kRounding * displacement;
}

bool RestWatch::add(const Movement& movement, const SolverSettings& settings, double size) {
  const auto still = [&](double way, double seconds) {
    return is_still(way, seconds, movement.displacement, settings, size);
  };
  const double h = settings.substep();
  if (still(movement.way, movement.duration) && still(h * movement.speed, h)) {
    quiet_ += movement.duration;
    ++checks_;
  } else {
    restart();
  }
  return settings.rest_speed > 0 && checks_ >= kLooks && quiet_ >= kQuiet;
}

}  // namespace fascia
