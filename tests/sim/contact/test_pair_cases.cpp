// Tissue against tissue in the reference solver, against closed forms: stacks, collisions, what must not come apart.
#include <catch2/catch.hpp>

#include "sim/contact/pair_search.h"
#include "sim/contact/penetration.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using test::beside;
using test::box_model;
using test::moved;
using test::soft;

SolverSettings frames() {
  SolverSettings settings;
  settings.time_step = 1.0 / 60;
  return settings;
}

Tool ground() {
  Tool tool;
  tool.name = "ground";
  tool.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
  tool.friction = 0.5;
  tool.path.emplace_back();
  return tool;
}

TEST_CASE("a stack of two cubes presses with once and twice a weight", "[contact]") {
  const Material material = soft(1e5, 0.3, 0.05);
  // Meshes whose vertices do not meet, and the upper cube sticks out.
  Model model = beside(box_model(3, 3, 3, {0.2, 0.2, 0.2}, material),
                       moved(box_model(4, 4, 4, {0.2, 0.2, 0.2}, material), {0.03, 0.2, 0.02}), "upper");
  model.gravity = {0, -9.81, 0};
  model.tools = {ground()};
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  for (int i = 0; i < 240; ++i) {
    const NewtonReport report = solver.step(state);
    CAPTURE(i, report.iterations, report.relative_residual);
    CHECK(report.converged);
  }
  const std::vector<PairLoad>& loads = solver.pair_loads();
  REQUIRE(loads.size() == 1);
  CAPTURE(loads[0].force.transpose(), loads[0].pairs, loads[0].deepest, solver.tool_loads()[0].force.transpose());
  CHECK(loads[0].bodies == std::array<std::uint32_t, 2>{0, 1});
  CHECK((loads[0].force - Vector3d(0, 78.48, 0)).norm() < 1e-4 * 78.48);
  CHECK((solver.tool_loads()[0].force - Vector3d(0, 2 * 78.48, 0)).norm() < 1e-4 * 78.48);
  CHECK(loads[0].deepest < 0.01 * PairSearch(model).skin());
  CHECK(penetrating_triangles(model, state.displacement) == 0);
}

}  // namespace
}  // namespace fascia::reference
