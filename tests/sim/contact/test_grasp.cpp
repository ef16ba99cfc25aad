// A grasp in the reference solver: a cube that two boxes squeeze and lift is held by friction, until they press with
// less than its weight needs.
// Covers: contact_energy
#include <catch2/catch.hpp>

#include "sim/reference/newton.h"
#include "tests/sim/contact/grasp.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

TEST_CASE("a grasp holds a cube for three seconds without creep", "[contact]") {
  const test::Grasp grasp;
  reference::NewtonSolver solver(grasp.model, test::Grasp::settings());
  State state = initial_state(grasp.model);
  while (state.time < test::Grasp::kHeld - 1e-9) solver.step(state);
  const Vector3d lifted = test::mean(state.displacement);
  while (state.time < test::Grasp::kHeld + 3 - 1e-9) solver.step(state);
  const double creep = (test::mean(state.displacement) - lifted).norm() / 3;  // [m/s]
  const std::vector<ToolLoad>& loads = solver.tool_loads();
  CAPTURE(lifted.transpose(), creep, loads[0].force.transpose(), loads[1].force.transpose(),
          loads[2].force.transpose());
  CHECK(loads[0].points == 0);
  CHECK(loads[1].normal == Approx(std::abs(loads[1].force.x())).epsilon(1e-6));  // whose sides are along x
  CHECK(loads[1].force.y() + loads[2].force.y() == Approx(test::Grasp::kWeight).epsilon(1e-4));
  CHECK(lifted.y() > 0.9 * test::Grasp::kLift);
  CHECK(creep < 1e-6);
}

TEST_CASE("a grasp lets a cube go when it presses with less than the weight over twice the friction", "[contact]") {
  const test::Grasp grasp;
  reference::NewtonSolver solver(grasp.model, test::Grasp::settings());
  State state = initial_state(grasp.model);
  while (state.time < test::Grasp::kOpening - 1e-9) solver.step(state);
  const double held = test::mean(state.displacement).y();
  double least = 1e9;  // that held, of a side [N]
  while (held - test::mean(state.displacement).y() < 1e-3 && state.time < test::Grasp::kOpening + 4) {
    solver.step(state);
    least = std::min(std::abs(solver.tool_loads()[1].force.x()), least);
  }
  const double limit = test::Grasp::kWeight / (2 * test::Grasp::kFriction);
  CAPTURE(state.time, least, limit, test::mean(state.velocity).y());
  CHECK(least == Approx(limit).epsilon(0.1));
  for (int i = 0; i < 12; ++i) solver.step(state);
  CHECK(test::mean(state.velocity).y() < -0.1);
}

}  // namespace
}  // namespace fascia
