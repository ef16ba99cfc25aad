#include "sim/replay/input_log.h"

#include <algorithm>

namespace fascia {

namespace {

struct Applying {
  Tuning& tuning;
  void operator()(const SolverSettings& settings) { tuning.solver = settings; }
  void operator()(const MaterialInput& input) { tuning.materials[input.index] = input.material; }
  void operator()(const GravityInput& input) { tuning.gravity = input.gravity; }
  void operator()(const GrabInput& springs) { tuning.springs = springs; }
  void operator()(const InstrumentInput& input) {
    LedTools led;
    led.restart(tuning.led);
    led.lead(input);
    tuning.led = led.tools();
  }
  template <class Other>
  void operator()(const Other&) {}  // no value to keep
};

}  // namespace

void Tuning::apply(const Input& input) { std::visit(Applying{*this}, input.change); }

void InputLog::restart(long step, Tuning tuning) {
  begin_ = step;
  tuning_ = std::move(tuning);
  inputs_.clear();
}

void InputLog::add(Input input) {
  // Several moves of a slider between two steps act as one; each input of springs replaces all springs.
  if (!inputs_.empty() && inputs_.back().step == input.step && inputs_.back().change.index() == input.change.index() &&
      !std::holds_alternative<MaterialInput>(input.change) && !std::holds_alternative<InstrumentInput>(input.change))
    inputs_.back() = std::move(input);
  else
    inputs_.push_back(std::move(input));
}

void InputLog::forget_before(long step) {
  const auto end = std::find_if(inputs_.begin(), inputs_.end(), [&](const Input& input) { return input.step >= step; });
  for (auto it = inputs_.begin(); it != end; ++it) tuning_.apply(*it);
  inputs_.erase(inputs_.begin(), end);
  begin_ = step;
}

}  // namespace fascia
