#include "sim/model/state.h"

#include "sim/model/model.h"

namespace fascia {

State initial_state(const Model& model) {
  State state;
  state.displacement.assign(model.rest_positions.size(), Eigen::Vector3d::Zero());
  state.velocity = model.initial_velocity;
  return state;
}

}  // namespace fascia
