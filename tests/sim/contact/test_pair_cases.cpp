// Tissue against tissue in the reference solver, against closed forms: stacks, collisions, what must not come apart.
#include <catch2/catch.hpp>

#include "sim/contact/pair_search.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using test::beside;
using test::box_model;
using test::frames;
using test::moved;
using test::soft;

Tool ground() {
  Tool tool;
  tool.name = "ground";
  tool.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
  tool.friction = 0.5;
  tool.path.emplace_back();
  return tool;
}

// Meshes whose vertices do not meet, and the upper cube sticks out.
Model stack(const Material& material) {
  Model model = beside(box_model(3, 3, 3, {0.2, 0.2, 0.2}, material),
                       moved(box_model(4, 4, 4, {0.2, 0.2, 0.2}, material), {0.03, 0.2, 0.02}), "upper");
  model.gravity = {0, -9.81, 0};
  model.tools = {ground()};
  return model;
}

// In motion vertices wander between faces of the other cube, by which forces change a little; at rest they do not.
TEST_CASE("a stack of two cubes presses with once and twice a weight", "[contact]") {
  const Model model = stack(soft(1e5, 0.3, 0.05));
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  int unsolved = 0;
  for (int i = 0; i < 240; ++i) unsolved += solver.step(state).converged ? 0 : 1;
  CHECK(unsolved == 0);
  const std::vector<PairLoad>& loads = solver.pair_loads();
  REQUIRE(loads.size() == 1);
  CAPTURE(loads[0].force.transpose(), loads[0].pairs, loads[0].deepest, solver.tool_loads()[0].force.transpose());
  CHECK(loads[0].bodies == std::array<std::uint32_t, 2>{0, 1});
  CHECK((loads[0].force - Vector3d(0, 78.48, 0)).norm() < 1e-3 * 78.48);
  CHECK((solver.tool_loads()[0].force - Vector3d(0, 2 * 78.48, 0)).norm() < 1e-3 * 78.48);
  CHECK(loads[0].deepest < 0.01 * PairSearch(model).skin());
  CHECK(penetrating_triangles(model, state.displacement) == 0);
}

// Each keeps what the other gives it; the closing speed is a fifth of that of waves in the cubes.
TEST_CASE("a collision in free flight keeps the momentum of both", "[contact]") {
  const Material material = soft(1e5);
  Model model =
      beside(moved(box_model(3, 3, 3, {0.2, 0.2, 0.2}, material), {0, 0, 0}, {1.5, 0, 0}),
             moved(box_model(4, 4, 4, {0.2, 0.2, 0.2}, material), {0.23, 0.03, 0.02}, {-0.5, 0, 0}), "second");
  model.contact.friction = 0.3;
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const Measures before = measure(model, state);
  double largest_force = 0;
  for (int i = 0; i < 30; ++i) {
    const NewtonReport report = solver.step(state);
    CAPTURE(i, report.iterations, report.relative_residual);
    CHECK(report.converged);
    for (const PairLoad& load : solver.pair_loads()) largest_force = std::max(largest_force, load.force.norm());
    const Measures now = measure(model, state);
    CAPTURE(now.momentum.transpose(), before.momentum.transpose(), now.kinetic + now.elastic);
    CHECK((now.momentum - before.momentum).norm() < 1e-6 * before.momentum.norm());
    CHECK(now.kinetic + now.elastic <= before.kinetic * (1 + 1e-9));
    CHECK(penetrating_triangles(model, state.displacement) == 0);
  }
  CHECK(largest_force > 50);
  CHECK(solver.pair_loads().empty());
}

// Places of the cube after every `interval` steps.
std::vector<Vector3d> way_down_slope(const Model& model, int steps, int interval) {
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  std::vector<Vector3d> places;
  for (int i = 0; i <= steps; ++i) {
    if (i % interval == 0) places.push_back(test::mean_displacement_of_second(model, state));
    if (i < steps) solver.step(state);
  }
  return places;
}

// So soft that its rim bulges and its faces crease: pairs that took slots from each other let it creep by 0.1 mm/s.
TEST_CASE("a soft cube rests on a slope of tissue below the limit of friction", "[contact]") {
  Material material = soft(1e4, 0.3, 0.05);
  material.model = MaterialModel::squared;
  const Model model = test::cube_on_slope(0.7 * 0.4, 0.4, material);
  const std::vector<Vector3d> places = way_down_slope(model, 180, 60);
  CAPTURE(places[1].transpose(), places[2].transpose(), places[3].transpose());
  CHECK((places[3] - places[2]).norm() < 1e-7);
  CHECK(places[3].x() > -0.03);
}

// What presses in a step for the first time has no friction in it, and rims that bend on their way take energy.
TEST_CASE("a cube slides down tissue above the limit of friction as Coulomb says", "[contact]") {
  const double slope = 1.2 * 0.4;
  const std::vector<Vector3d> places = way_down_slope(test::cube_on_slope(slope, 0.4, soft(1e5, 0.3, 0.05)), 40, 10);
  const double acceleration = -(places[4] - 2 * places[3] + places[2]).x() * 36;
  const double coulomb = 9.81 / std::hypot(1, slope) * (slope - 0.4);
  CAPTURE(acceleration, coulomb);
  CHECK(acceleration == Approx(coulomb).epsilon(0.05));
}

TEST_CASE("cubes set on each other have a static equilibrium", "[contact]") {
  const Model model = stack(soft(1e5));
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state);
  REQUIRE(solver.pair_loads().size() == 1);
  const Vector3d between = solver.pair_loads()[0].force, below = solver.tool_loads()[0].force;
  CAPTURE(report.iterations, report.relative_residual, between.transpose(), below.transpose());
  CHECK(report.converged);
  CHECK((between - Vector3d(0, 78.48, 0)).norm() < 1e-6 * 78.48);
  CHECK((below - Vector3d(0, 2 * 78.48, 0)).norm() < 1e-6 * 78.48);
  CHECK(penetrating_triangles(model, state.displacement) == 0);
}

}  // namespace
}  // namespace fascia::reference
