#include "sim/model/state.h"

#include <algorithm>

#include "sim/model/model.h"

namespace fascia {

State initial_state(const Model& model) {
  State state;
  state.displacement.assign(model.rest_positions.size(), Eigen::Vector3d::Zero());
  state.velocity.assign(model.rest_positions.size(), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t)) state.velocity[v] = model.initial_velocity[v];
  return state;
}

bool is_finite(const State& state) {
  const auto finite = [](const Eigen::Vector3d& v) { return v.allFinite(); };
  return std::all_of(state.displacement.begin(), state.displacement.end(), finite) &&
         std::all_of(state.velocity.begin(), state.velocity.end(), finite);
}

// Through memory, since g++ 12 drops the two conversions where it vectorizes them.
Eigen::Vector3d float32_of(const Eigen::Vector3d& v) {
  volatile float stored[3];
  for (int k = 0; k < 3; ++k) stored[k] = static_cast<float>(v[k]);
  return {stored[0], stored[1], stored[2]};
}

}  // namespace fascia
