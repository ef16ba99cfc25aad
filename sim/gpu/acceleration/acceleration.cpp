#include "sim/gpu/acceleration/acceleration.h"

#include <algorithm>
#include <iterator>

#include "sim/gpu/acceleration/chebyshev.h"

namespace fascia {
namespace {

using Made = std::unique_ptr<StepAcceleration>;
using Inputs = AccelerationInputs;

// Goes with methods whose iterations start at the prediction.
class ChebyshevAcceleration : public StepAcceleration {
 public:
  explicit ChebyshevAcceleration(const Inputs& inputs) : chebyshev_(inputs.programs, inputs.buffers.vertex_count) {}
  Passes after_iteration(const Recording& r, bool first) const override {
    return chebyshev_.passes(r.programs, r.buffers.step, r.buffers.predicted, r.buffers.displacement, first);
  }
  void values_changed() override { chebyshev_.forget_spectral_radius(); }

 private:
  Chebyshev chebyshev_;
};

class AndersonAcceleration : public StepAcceleration {
 public:
  AndersonAcceleration(const Inputs& inputs, std::vector<AndersonPart> state)
      : anderson_(inputs.programs, std::move(state), inputs.settings.window) {}
  Passes begin(const Recording& r) const override { return anderson_.begin(r.programs); }
  Passes after_iteration(const Recording& r, bool first) const override { return anderson_.passes(r.programs, first); }

 private:
  Anderson anderson_;
};

struct Row {
  Acceleration acceleration;
  Made (*make)(const Inputs& inputs);
};
constexpr Row kAccelerations[] = {
    {Acceleration::chebyshev, [](const Inputs& i) -> Made { return std::make_unique<ChebyshevAcceleration>(i); }},
    {Acceleration::anderson_positions,
     [](const Inputs& i) -> Made {
       std::vector<AndersonPart> positions{{&i.buffers.displacement, i.buffers.vertex_count, nullptr}};
       return std::make_unique<AndersonAcceleration>(i, std::move(positions));
     }},
    {Acceleration::anderson,
     [](const Inputs& i) -> Made {
       return i.state.empty() ? nullptr : std::make_unique<AndersonAcceleration>(i, i.state);
     }},
};

}  // namespace

std::unique_ptr<StepAcceleration> make_acceleration(const AccelerationInputs& inputs) {
  const auto row = std::find_if(std::begin(kAccelerations), std::end(kAccelerations),
                                [&](const Row& r) { return r.acceleration == inputs.settings.acceleration; });
  return row == std::end(kAccelerations) ? nullptr : row->make(inputs);
}

}  // namespace fascia
