// Maps real time to equal steps: the number of steps in a frame, the limit at which the scene falls behind real time,
// and the resulting speed.
#pragma once

namespace fascia {

class Pacing {
 public:
  /// Returns the number of steps to make, `elapsed` seconds of real time after the last call. `step_cost` is the
  /// current time of a step [s], 0 if unknown. A frame gets only as many steps as keep it smooth, at least one, and
  /// more where pictures are slow; time that does not fit is dropped, not owed.
  int advance(double elapsed, double time_step, double step_cost);
  /// After a pause, a reset or an opened scene: no steps are owed and the speed is measured anew.
  void restart();

  /// While nothing has to be solved: the speed is measured anew from the next step on, and owed steps stay owed.
  void forget_speed() { simulated_ = real_ = 0; }

  /// Simulated time over real time of about the last second; 1 when keeping pace.
  double speed() const { return real_ > 0 ? simulated_ / real_ : 1; }
  /// True also while the measured time is too short to judge.
  bool keeps_pace() const { return real_ < 0.5 || speed() > 0.95; }

 private:
  // Half a step ahead, so that frames as long as a step (60 Hz, 1/60 s) do not waver between no step and two.
  static constexpr double kHead = 0.5;

  double owed_ = kHead;              // in steps
  int steps_ = 0;                    // of the last frame
  double picture_ = 0;               // time of a frame without its steps, an average with decaying weights [s]
  double simulated_ = 0, real_ = 0;  // [s], both fading with the same time constant
};

}  // namespace fascia
