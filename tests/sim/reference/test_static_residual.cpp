// The distance of a state from equilibrium: 0 in equilibrium, known shares elsewhere.
#include "sim/reference/static_residual.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;

Model hanging() {
  Model model =
      test::box_model(3, 1, 1, {0.3, 0.1, 0.1}, test::soft(1e5), [](const Vector3d& x) { return x.x() < 1e-9; });
  model.gravity = {0, -9.81, 0};
  return model;
}

}  // namespace

TEST_CASE("at rest the residual is the weight of the free vertices over the whole weight") {
  const Model model = hanging();
  const std::vector<double> masses = consistent_masses(model);
  double all = 0, free = 0;
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < masses.size(); ++v) {
    all += masses[v] * masses[v];
    if (!held[v]) free += masses[v] * masses[v];
  }
  CHECK(StaticResidual(model)(initial_state(model)) == Approx(std::sqrt(free / all)));
}

TEST_CASE("the residual is zero in equilibrium, positive beside it, and zero without forces") {
  Model model = hanging();
  State state = initial_state(model);
  NewtonSolver solver(model, {});
  REQUIRE(solver.solve_static(state).converged);
  const StaticResidual residual(model);
  CAPTURE(residual(state));
  CHECK(residual(state) < 1e-9);
  state.displacement.back().y() += 1e-4;
  CHECK(residual(state) > 1e-3);

  model.gravity.setZero();
  CHECK(StaticResidual(model)(initial_state(model)) == 0);
}

TEST_CASE("springs are forces") {
  Model model = hanging();
  const auto tip = static_cast<std::uint32_t>(model.rest_positions.size() - 1);
  REQUIRE(!model.held()[tip]);
  const std::vector<GrabSpring> springs{{tip, {0, 0.05, 0}, 200}, {tip, {0.01, 0, 0}, 50}};
  State state = initial_state(model);
  NewtonSolver solver(model, {});
  solver.set_springs(springs);
  REQUIRE(solver.solve_static(state).converged);
  const StaticResidual residual(model);
  CAPTURE(residual(state, springs), residual(state));
  CHECK(residual(state, springs) < 1e-9);
  CHECK(residual(state) > 1e-2);

  // Only a spring pulls at a body at rest: the residual is the whole load.
  model.gravity.setZero();
  CHECK(StaticResidual(model)(initial_state(model), springs) == Approx(1));
}

TEST_CASE("what touches carries the weight") {
  Model model = hanging();
  model.fixed.clear();
  Tool ground;
  ground.name = "ground";
  ground.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
  ground.friction = 0.5;
  ground.path = {{}};
  model.tools = {ground};
  State state = initial_state(model);
  NewtonSolver solver(model, {});
  REQUIRE(solver.solve_static(state).converged);
  const StaticResidual residual(model);
  CAPTURE(residual(state, {}, solver.contact_forces()), residual(state));
  CHECK(residual(state, {}, solver.contact_forces()) < 1e-8);
  CHECK(residual(state) > 0.1);
}

}  // namespace fascia::reference
