// A rigid ball on an elastic half space (Hertz 1882): F = 4/3 E / (1 - nu^2) sqrt(R) depth^1.5. The half space is a
// block of quadratic tets whose edges grow with the distance from the ball, held at its far sides. Covers:
// contact_surface
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;

TEST_CASE("a ball pressed into a half space meets the force of Hertz", "[contact]") {
  constexpr double kRadius = 0.1, kDepth = 0.005, kYoung = 1e5, kRatio = 0.3;
  constexpr int kCells = 4;                          // from the ball to every side
  constexpr double kFirst = 0.0112, kGrowth = 3.13;  // half of the radius of contact; 0.49 m to the sides
  const auto place = [](double cells) {
    return std::copysign(kFirst * (std::pow(kGrowth, std::abs(cells)) - 1) / (kGrowth - 1), cells);
  };
  Model model =
      test::box_model(2 * kCells, kCells, 2 * kCells, {2.0 * kCells, kCells, 2.0 * kCells}, test::soft(kYoung, kRatio));
  for (Vector3d& x : model.rest_positions) x = (x - Vector3d::Constant(kCells)).unaryExpr(place);
  model.file_mesh.positions = model.rest_positions;
  const double far = 0.999 * place(kCells);
  model.fixed = test::vertices_where(
      model, [&](const Vector3d& x) { return std::abs(x.x()) > far || x.y() < -far || std::abs(x.z()) > far; });
  model = test::quadratic(std::move(model));
  Tool ball;
  ball.name = "ball";
  ball.shape = SphereShape{{0, 0, 0}, kRadius};
  ball.path = {{0, {0, kRadius, 0}, {0, 0, 0}}, {1, {0, kRadius - kDepth, 0}, {0, 0, 0}}};
  model.tools = {ball};
  NewtonSolver solver(model, {});
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state, 1e-5);
  const ToolLoad& load = solver.tool_loads().front();
  const double exact = 4.0 / 3 * kYoung / (1 - kRatio * kRatio) * std::sqrt(kRadius) * std::pow(kDepth, 1.5);
  CAPTURE(load.force.transpose(), exact, load.points, load.deepest, report.iterations);
  CHECK(report.converged);
  CHECK(-load.force.y() == Approx(exact).epsilon(0.05));
  CHECK(std::hypot(load.force.x(), load.force.z()) < 0.01 * exact);
  CHECK(load.deepest < 1e-4 * kDepth);
}

}  // namespace
}  // namespace fascia::reference
