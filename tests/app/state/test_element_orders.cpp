// States of a model in one of other elements.
#include <catch2/catch.hpp>

#include "app/state/element_orders.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model box() {
  return make_model(make_box(2, 1, 1, {0.2, 0.1, 0.1}), Material{}, [](const Vector3d& x) { return x.x() < 1e-9; });
}

}  // namespace

TEST_CASE("the elements of a scene are those of its bodies") {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[1].elements = ElementOrder::quadratic;
  CHECK(elements_of(scene) == ElementOrders{ElementOrder::linear, ElementOrder::quadratic});
}

TEST_CASE("a state in other elements keeps the corners, and middles lie between them") {
  const Model linear = box();
  Model curved = quadratic(box());
  curved.bodies[0].vertex_count = static_cast<std::uint32_t>(curved.rest_positions.size());
  State state = random_state(linear, 0.01, 4);
  state.time = 1.5;
  state.earlier = {state.displacement, state.velocity, 0.01};
  CHECK(with_elements(state, linear, linear).displacement == state.displacement);
  CHECK(with_elements(state, linear, linear).earlier.step == 0.01);

  const State more = with_elements(state, linear, curved);
  CHECK(more.time == 1.5);
  CHECK(more.earlier.step == 0);
  REQUIRE(more.displacement.size() == curved.rest_positions.size());
  for (std::size_t v = 0; v < linear.rest_positions.size(); ++v) {
    CHECK(more.displacement[v] == state.displacement[v]);
    CHECK(more.velocity[v] == state.velocity[v]);
  }
  for (const MidEdge& edge : mid_edges_of(curved.file_mesh)) {
    CHECK(more.displacement[edge.vertex] == 0.5 * (state.displacement[edge.a] + state.displacement[edge.b]));
    CHECK(more.velocity[edge.vertex] == 0.5 * (state.velocity[edge.a] + state.velocity[edge.b]));
  }
  const State back = with_elements(more, curved, linear);
  CHECK(back.displacement == state.displacement);
  CHECK(back.velocity == state.velocity);
}
