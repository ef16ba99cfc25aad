#include "app/window/stepping.h"

#include <algorithm>

#include "app/panels/panels.h"
#include "app/window/parts/compile_notice.h"

namespace fascia {

bool Stepping::still() const {
  return stage_.state.paused || (sides_.asleep() && left_ < 0 && !stage_.simulation().awaits_inputs());
}

int Stepping::due(double elapsed, bool one) {
  const Simulation& simulation = stage_.simulation();
  const WindowState& state = stage_.state;
  Statistics& s = stage_.state.statistics;
  const bool ready = simulation.ready();
  s.waits = ready ? 0 : s.waits + elapsed;
  if (state.paused || !ready) {
    stage_.pacing.restart();
    return state.paused && one ? 1 : 0;
  }
  const bool replaying = simulation.replaying();
  const int steps = stage_.pacing.advance(elapsed * (replaying ? state.replay_speed : 1),
                                          simulation.scene.solver.time_step, s.step_ms / 1000);
  if (!replaying) return steps;
  return static_cast<int>(std::min<long>(steps, simulation.replay()->steps - simulation.replayed_steps()));
}

void Stepping::advance(double elapsed, bool one) {
  int steps = due(elapsed, one);
  if (left_ >= 0) steps = static_cast<int>(std::min<long>(steps, left_));
  simulated_ = 0;
  compiled_ = false;
  const bool repeats = stage_.simulation().repeating();
  if (steps > 0) {
    const CompileNotice notice(graphics_, overlay_, *stage_.framebuffer, stage_.panels_cover());
    timer_.begin();
    for (int i = 0; i < steps; ++i) make_step();
    compiled_ = notice.kernels() > 0;
    timer_.end(steps, compiled_);
  }
  while (const auto took = timer_.take())
    stage_.state.statistics.add_steps(took->milliseconds, took->steps, took->compiled, stats_.step_ms);
  if (still()) stage_.pacing.forget_speed();  // without solving no speed is measured
  if (repeats) sides_.accept_tunables_of_a();
}

void Stepping::make_step() {
  WindowState& state = stage_.state;
  stage_.mouse.pull(sides_.held());
  stage_.hand.lead(sides_.held());
  if ((state.show_panels && state.show_convergence) || shows_convergence(state.plots))
    state.convergence.measure(sides_.tuned().simulation, *graphics_.programs);
  const bool slept = sides_.asleep();
  sides_.step();
  simulated_ += stage_.simulation().scene.solver.time_step;
  stage_.diagnose |= !slept || !sides_.asleep();  // also after the step before the sleep
  ++state.statistics.steps;
  ++stats_.steps;
  if (left_ > 0) --left_;
}

}  // namespace fascia
