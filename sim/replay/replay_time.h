// When a replay's steps are: a session may change the time step as it goes.
#pragma once
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

class ReplayTime {
 public:
  explicit ReplayTime(const Replay& replay);

  double seconds(long steps) const;   // that so many steps take
  long steps(double seconds) const;   // that come closest to it
  double time_step(long step) const;  // of that step, the first is 0 [s]
  double longest_step() const;        // [s]

 private:
  struct Part {
    long step;                // the first one
    double begin, time_step;  // [s]
  };
  const Part& part_of(long step) const;
  std::vector<Part> parts_;
};

}  // namespace fascia
