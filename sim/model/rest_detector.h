// When a body is at rest: nothing in it has moved for a while by more than what counts (solver.rest_speed) or what
// float32 rounds.
#pragma once
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

/// The most that a vertex did between two looks at the state.
struct Movement {
  double duration = 0;      // from one look to the other [s]
  double way = 0;           // from its place then to its place now [m]
  double speed = 0;         // now [m/s]
  double displacement = 0;  // now [m]
};

/// Whether a way [m] within `seconds` is no movement: below solver.rest_speed, or what float32 rounds of a displacement
/// [m]. `size` of the scene [m].
bool is_still(double way, double seconds, double displacement, const SolverSettings& settings, double size);

class RestWatch {
 public:
  /// Whether it is at rest after this look. `size` of the scene [m].
  bool add(const Movement& motion, const SolverSettings& settings, double size);
  double quiet() const { return quiet_; }  // [s] at rest without a break
  /// Something acts on it anew.
  void restart() {
    quiet_ = 0;
    checks_ = 0;
  }

 private:
  double quiet_ = 0;
  int checks_ = 0;  // in that time
};

}  // namespace fascia
