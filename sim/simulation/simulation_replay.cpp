// Records the inputs of a simulation, and repeats them in a replay.
#include <algorithm>

#include "base/error.h"
#include "sim/contact/first_state.h"
#include "sim/simulation/simulation.h"

namespace fascia {

void Simulation::require_fit(const Replay& replay) const {
  const auto fail = [&](const std::string& what, const std::string& expected) {
    throw Error(replay.scene.file.string(), what, expected);
  };
  const std::size_t vertices = model.rest_positions.size();
  if (replay.start && replay.start->displacement.size() != vertices)
    fail("start has " + std::to_string(replay.start->displacement.size()) + " vertices",
         "expected the mesh's " + std::to_string(vertices));
  const auto require_instrument = [&](const std::string& name, const std::string& who) {
    for (const Instrument& instrument : scene.tools.instruments)
      if (instrument.name == name) return;
    fail(who + " leads " + name, "expected an instrument of the scene");
  };
  if (replay.start)
    for (const LedTool& led : replay.start->led) require_instrument(led.name, "start");
  GrabTrack held;
  for (const Input& input : replay.inputs) {
    const auto* material = std::get_if<MaterialInput>(&input.change);
    if (material && material->index >= model.materials.size())
      fail("an input changes material " + std::to_string(material->index),
           "expected an index below " + std::to_string(model.materials.size()));
    if (const auto* springs = std::get_if<GrabInput>(&input.change)) {
      for (const GrabSpring& spring : *springs)
        if (spring.vertex >= vertices)
          fail("an input grabs vertex " + std::to_string(spring.vertex),
               "expected an index below " + std::to_string(vertices));
      held.restart(*springs);
    }
    if (const auto* led = std::get_if<InstrumentInput>(&input.change)) require_instrument(led->name, "an input");
    if (const auto* move = std::get_if<GrabMove>(&input.change); move && !held.fits(*move))
      fail("an input before step " + std::to_string(input.step) + " moves other springs than those of the grab",
           "expected parts that cover them");
  }
}

void Simulation::play(Replay replay) {
  require_fit(replay);
  start_ = replay.start;
  replay_ = std::move(replay);
  replay_tuning_ = {scene.solver, model.materials, model.gravity, {}};
  reset();
}

void Simulation::end_replay() {
  replay_.reset();
  if (gpu_) gpu_->hold_background(false);
}

bool Simulation::led_back_later() const {
  if (!replay_) return false;
  return std::any_of(replay_->inputs.begin() + static_cast<std::ptrdiff_t>(next_input_), replay_->inputs.end(),
                     [](const Input& input) {
                       return std::holds_alternative<RestoreInput>(input.change) ||
                              std::holds_alternative<ResetInput>(input.change);
                     });
}

void Simulation::tell(long step, Change change) const {
  if (listener_) listener_({step, std::move(change)});
}

void Simulation::tell_of_background(long step) {
  if (!gpu_) return;
  if (const int results = gpu_->background_taken(); results > 0) tell(step, BackgroundInput{results});
}

void Simulation::repeat(const Change& change) {
  struct Visitor {
    Simulation& simulation;
    void operator()(const SolverSettings& settings) { simulation.set_settings(settings); }
    void operator()(const MaterialInput& input) { simulation.set_material(input.index, input.material); }
    void operator()(const GravityInput& input) { simulation.set_gravity(input.gravity); }
    void operator()(const GrabInput& springs) {
      simulation.held_.restart(springs);
      simulation.apply_grab(springs, springs);
    }
    void operator()(const GrabMove& move) {
      if (simulation.held_.fits(move))
        simulation.apply_grab(simulation.held_.moved(move), move);  // otherwise set_grab() has taken over
    }
    void operator()(const InstrumentInput& led) { simulation.lead(led); }
    void operator()(const GrantInput& input) { simulation.grant(input.iterations); }
    void operator()(const BackgroundInput& input) {
      if (!simulation.gpu_) return;
      simulation.gpu_->take_background(input.results);
      simulation.tell(input);
    }
    void operator()(const ResetInput& reset) { simulation.go_back_to(reset.to_rest); }
    void operator()(const RestoreInput&) {
      if (!simulation.gpu_ || simulation.reference_) return;
      simulation.follow_check(true);  // so that the last valid state is the same
      simulation.back_to_valid();
      simulation.begin_anew();
    }
    void operator()(const CameraSettings&) {}  // the drawing code applies these
    void operator()(const DisplaySettings&) {}
  };
  std::visit(Visitor{*this}, change);
}

void Simulation::repeat_inputs() {
  if (!replay_) return;
  for (; next_input_ < replay_->inputs.size() && replay_->inputs[next_input_].step <= steps_ - replay_begin_;
       ++next_input_) {
    repeat(replay_->inputs[next_input_].change);
    // Background results would be ready at a different step in each run.
    if (gpu_ && !replay_->timed) gpu_->finish_background();
    tell_of_background(steps_);
  }
}

void Simulation::reset() {
  if (replay_) {
    if (gpu_) gpu_->hold_background(false);
    set_settings(replay_tuning_.solver);
    for (std::size_t i = 0; i < model.materials.size(); ++i) set_material(i, replay_tuning_.materials[i]);
    set_gravity(replay_tuning_.gravity);
    set_grab({});
    if (gpu_) {
      gpu_->finish_background();
      gpu_->hold_background(replay_->timed);
    }
    tell_of_background(steps_);
    next_input_ = 0;
    replay_begin_ = steps_;
  }
  go_back_to(!start_);
  if (!replaying()) repeat_inputs();  // for a replay without steps
}

void Simulation::go_back_to(bool rest) {
  leave_equilibrium();
  const State start = rest || !start_ ? first_state(model) : *start_;
  if (reference_) reference_state_ = start;
  if (gpu_) gpu_->upload(start);
  led_.restart(start.led);
  pull(with_grabs(other_springs_, model.grabs, time() + scene.solver.time_step));
  diverged_.reset();
  begin_anew();
  tell(ResetInput{rest});
}

}  // namespace fascia
