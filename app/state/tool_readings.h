// The forces of tools as the panels show them: means over the last readings, since every new point of contact is an
// impact and forces of single steps scatter.
#pragma once
#include <deque>
#include <vector>

#include "sim/contact/tool_load.h"

namespace fascia {

class ToolReadings {
 public:
  static constexpr std::size_t kMean = 5;  // readings, one a frame, of its last step

  /// [tool] at a simulated time [s]; a time that has gone back begins anew, and the same one again counts once.
  void add(double time, const std::vector<ToolLoad>& loads);
  void forget() { readings_.clear(); }
  /// [tool] mean force and torque, with points and depth of the last reading; empty before the first one.
  std::vector<ToolLoad> mean() const;

 private:
  struct Reading {
    double time;
    std::vector<ToolLoad> loads;
  };
  std::deque<Reading> readings_;
};

}  // namespace fascia
