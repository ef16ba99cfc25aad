// Distances of the surface from the tools.
#include "sim/contact/contact_gap.h"

#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

TEST_CASE("the gap is the distance to the nearest tool, and unknown inside", "[contact]") {
  Model model = test::box_model(2, 2, 2, {0.2, 0.2, 0.2}, test::soft(1e5));
  model.contact.thickness = 0.002;
  SceneTools tools;
  tools.ground = Ground{-0.03, 0.5};
  Instrument ball;
  ball.name = "ball";
  ball.shape = ToolShape(SphereShape{{0, 0, 0}, 0.05});
  ball.path = {{0, {0.1, 0.27, 0.1}, {0, 0, 0}}, {1, {0.1, 0.23, 0.1}, {0, 0, 0}}};
  tools.instruments.push_back(ball);
  model.tools = tools_of(tools);
  State state = initial_state(model);
  for (Vector3d& u : state.displacement) u.y() = 0.01;
  const auto gap_at = [&](double time, const Vector3d& rest) {
    const std::vector<double> gaps = contact_gaps(model, state, places_at(model.tools, time));
    REQUIRE(gaps.size() == model.rest_positions.size());
    for (std::size_t v = 0; v < gaps.size(); ++v)
      if (model.rest_positions[v].isApprox(rest, 1e-12)) return gaps[v];
    return 1e9;
  };
  CHECK(gap_at(0, {0.2, 0.0, 0.2}) == Approx(0.01 + 0.03 - 0.001));
  CHECK(gap_at(0, {0.1, 0.2, 0.1}) == Approx(0.06 - 0.05 - 0.001));
  CHECK(gap_at(1, {0.1, 0.2, 0.1}) == Approx(0.02 - 0.05 - 0.001));
  CHECK(std::isnan(gap_at(0, {0.1, 0.1, 0.1})));
}

}  // namespace
}  // namespace fascia
