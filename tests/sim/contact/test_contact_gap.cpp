// Distances of the surface from the tools.
#include "sim/contact/contact_gap.h"

#include <catch2/catch.hpp>

#include "sim/tool/solid_mesh.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/surfaces.h"

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

TEST_CASE("the gap to a tool that is a closed mesh is exact however far the tool is", "[contact]") {
  Model model = test::box_model(2, 2, 2, {0.2, 0.2, 0.2}, test::soft(1e5));
  const Vector3d size(0.04, 0.05, 0.06);
  const auto solid = std::make_shared<const SolidMesh>(solid_of(test::make_box_surface(size), 1, "box.obj"));
  for (const double away : {0.0, 0.002, 0.01, 0.05, 0.3}) {
    SceneTools tools;
    Instrument box;
    box.name = "box";
    MeshShape mesh;
    mesh.solid = solid;
    box.shape = ToolShape(mesh);
    box.path = {{0, {0.08, 0.2 + away, 0.07}, {0, 0, 0}}};
    tools.instruments = {box};
    model.tools = tools_of(tools);
    const State state = initial_state(model);
    const std::vector<double> gaps = contact_gaps(model, state, places_at(model.tools, 0));
    const ToolShape exact = BoxShape{size / 2, size / 2, 0};
    for (std::size_t v = 0; v < gaps.size(); ++v) {
      if (std::isnan(gaps[v])) continue;
      const double distance = distance_to(exact, model.rest_positions[v] - box.path[0].position).distance;
      CAPTURE(away, model.rest_positions[v].transpose(), gaps[v], distance);
      CHECK(std::abs(gaps[v] - distance) < (distance < 4 * std::sqrt(3) * solid->spacing ? solid->spacing : 1e-12));
    }
  }
}

}  // namespace
}  // namespace fascia
