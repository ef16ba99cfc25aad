// The times of a replay's steps: a session may change the time step while it runs.
#pragma once
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

class ReplayTime {
 public:
  explicit ReplayTime(const Replay& replay);

  double seconds(long steps) const;   // duration of so many steps
  long steps(double seconds) const;   // closest number of steps
  double time_step(long step) const;  // of that step, counted from 0 [s]
  double longest_step() const;        // [s]

 private:
  struct Part {
    long step;                // first step
    double begin, time_step;  // [s]
  };
  const Part& part_of(long step) const;
  std::vector<Part> parts_;
};

}  // namespace fascia
