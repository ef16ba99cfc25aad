// The steps of a frame: how many the clock requires, how long they take, and when no step is made.
#pragma once
#include "app/overlay/overlay.h"
#include "app/window/sides.h"
#include "gl/timing/timer.h"
#include "sim/output/stats.h"

namespace fascia {

class Stepping {
 public:
  Stepping(Graphics& graphics, Overlay& overlay, Stage& stage, Sides& sides)
      : graphics_(graphics), overlay_(overlay), stage_(stage), sides_(sides) {}

  void limit(long steps) { left_ = steps; }  // at most this many further steps are made
  bool done() const { return left_ == 0; }   // all steps of the limit are made
  bool still() const;                        // the tissue does not move

  /// `elapsed` seconds after the previous frame. `one` makes a step although the clock is paused.
  void advance(double elapsed, bool one);
  double simulated() const { return simulated_; }  // in the last advance() [s]
  bool compiled() const { return compiled_; }      // kernels, in the last advance()
  RunStats& stats() { return stats_; }             // of all steps made
  const RunStats& stats() const { return stats_; }

 private:
  int due(double elapsed, bool one);
  void make_step();

  Graphics& graphics_;
  Overlay& overlay_;
  Stage& stage_;
  Sides& sides_;
  gl::Timer timer_;
  RunStats stats_;
  long left_ = -1;  // negative without a limit
  double simulated_ = 0;
  bool compiled_ = false;
};

}  // namespace fascia
