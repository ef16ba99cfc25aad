// Decides when a body is at rest: for a while nothing in it has moved by more than the threshold (solver.rest_speed) or
// the rounding of float32.
#pragma once
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

/// The largest motion of any vertex between two checks of the state.
struct Movement {
  double duration = 0;      // between the checks [s]
  double way = 0;           // distance between its places at the two checks [m]
  double speed = 0;         // at the second check [m/s]
  double displacement = 0;  // at the second check [m]
};

/// Whether a distance `way` [m] within `seconds` counts as no movement: below solver.rest_speed, or below the rounding
/// of a displacement [m] in float32. `size` of the scene [m].
bool is_still(double way, double seconds, double displacement, const SolverSettings& settings, double size);

class RestWatch {
 public:
  /// Whether the body is at rest after this check. `size` of the scene [m].
  bool add(const Movement& motion, const SolverSettings& settings, double size);
  double quiet() const { return quiet_; }  // [s] at rest without interruption
  /// Starts again, after a change of the forces on the body.
  void restart() {
    quiet_ = 0;
    checks_ = 0;
  }

 private:
  double quiet_ = 0;
  int checks_ = 0;  // in that time
};

}  // namespace fascia
