#include <Eigen/Geometry>

#include "app/stress/case_maker.h"
#include "sim/grab/build_model.h"
#include "sim/model/model.h"

namespace fascia {

using Eigen::Vector3d;

// A free body: without external forces, energy and momenta must not increase.
void add_conservation(StressCases& c) {
  Scene s = c.beam_scene(false);
  std::optional<State> state = c.bent(s);
  const Model built = build_model(s);
  for (std::size_t v = 0; v < state->velocity.size(); ++v)
    state->velocity[v] = float32_of(Vector3d(1, 2, 0.5) + Vector3d(3, -2, 5).cross(built.rest_positions[v]));
  StressCase& made = c.add("conservation", "free and spinning", s, state, 90);
  made.criteria.farthest = 20;
  made.criteria.creates_no_energy = made.criteria.creates_no_momentum = true;
}

}  // namespace fascia
