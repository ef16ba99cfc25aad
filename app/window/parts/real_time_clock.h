// Real time in equal steps: how many steps a frame owes, when it must give up keeping pace, and how fast the scene then
// runs.
#pragma once

namespace fascia {

class Pacing {
 public:
  /// Steps to make now, `elapsed` seconds of real time after the last call. `step_cost` is what a step takes at the
  /// moment [s], 0 if unknown: a frame is given only the steps that leave it fluent, at least one, and time that does
  /// not fit is dropped, not owed.
  int advance(double elapsed, double time_step, double step_cost);
  /// After a pause, a reset or an opened scene: nothing is owed and the speed is measured anew.
  void restart();

  /// While nothing has to be solved: the speed is measured anew from the next step on, and what is owed stays owed.
  void forget_speed() { simulated_ = real_ = 0; }

  /// Simulated time over real time of about the last second; 1 when keeping pace.
  double speed() const { return real_ > 0 ? simulated_ / real_ : 1; }
  /// Also while too little has been seen to judge.
  bool keeps_pace() const { return real_ < 0.5 || speed() > 0.95; }

 private:
  // Half a step ahead, so that frames as long as a step (60 Hz, 1/60 s) do not waver between no step and two.
  static constexpr double kHead = 0.5;

  double owed_ = kHead;              // in steps
  double simulated_ = 0, real_ = 0;  // [s], both fading with the same time constant
};

}  // namespace fascia
