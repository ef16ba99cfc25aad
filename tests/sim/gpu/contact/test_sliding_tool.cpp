// A tool that slides over tissue drags it by Coulomb's friction, although its points come and go.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// Cells of 1 cm, held from below; a tool whose lowest point is `low` [m] below its middle is pressed 6 mm deep and
// slides at `speed` [m/s] for 3 cm.
Model slab_under(const ToolShape& shape, double low, double friction, double speed) {
  Model model = test::cube(0.1, 10, test::soft_tissue(1e5, 0.01));
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].y() == 0) model.fixed.push_back(v);
  model.gravity.setZero();
  model.tools = {test::tool("tool", shape, friction,
                            {{0, {0.035, 0.101 + low, 0.05}, {0, 0, 0}},
                             {0.2, {0.035, 0.094 + low, 0.05}, {0, 0, 0}},
                             {0.2 + 0.03 / speed, {0.065, 0.094 + low, 0.05}, {0, 0, 0}}})};
  return model;
}

Model slab_under_ball(double friction, double speed) {
  return slab_under(SphereShape{{0, 0, 0}, 0.025}, 0.025, friction, speed);
}

/// The force along the way over that across it, in the last two thirds of the way. `step` returns the tool's force.
template <class Step>
double drag_ratio(const Model& model, const SolverSettings& settings, Step&& step) {
  const double end = model.tools[0].end();
  Vector3d sum(0, 0, 0);
  for (double time = settings.time_step; time < end; time += settings.time_step) {
    const Vector3d force = step();
    if (time > end - 2.0 / 3 * (end - 0.2)) sum += force;
  }
  return sum.x() / -sum.y();
}

double drag_on_gpu(const Model& model) {
  test::Gpu gpu;
  const SolverSettings settings = test::two_level();
  GpuSolver solver(gpu.programs, model, settings);
  return drag_ratio(model, settings, [&] {
    solver.step();
    solver.request_diagnostics();
    return solver.take_diagnostics(true)->tool_loads.at(0).force;
  });
}

TEST_CASE("a ball that slides over tissue drags it with mu times its force", "[gpu][contact]") {
  const double friction = GENERATE(0.2, 0.5), speed = GENERATE(0.1, 0.02);
  const double smooth = drag_on_gpu(slab_under_ball(0, speed)), rough = drag_on_gpu(slab_under_ball(friction, speed));
  CAPTURE(friction, speed, smooth, rough);
  CHECK(std::abs(smooth) < 0.05);
  CHECK(rough - smooth == Approx(friction).epsilon(0.06));
}

// Few points touch them at a time, and bear much for their area.
TEST_CASE("tools as small as a cell drag tissue with most of mu times their force", "[gpu][contact]") {
  const int box = GENERATE(0, 1);
  const double speed = GENERATE(0.1, 0.02), friction = 0.5;
  const ToolShape shape =
      box == 1 ? ToolShape(BoxShape{{0, 0, 0}, {0.01, 0.01, 0.01}, 0.002}) : SphereShape{{0, 0, 0}, 0.01};
  const double smooth = drag_on_gpu(slab_under(shape, 0.01, 0, speed));
  const double rough = drag_on_gpu(slab_under(shape, 0.01, friction, speed));
  CAPTURE(box, speed, smooth, rough);
  CHECK(std::abs(smooth) < 0.1);
  CHECK(rough - smooth > 0.75 * friction);
  CHECK(rough - smooth < 1.1 * friction);
}

TEST_CASE("the drag of a ball that slides over tissue is that of the reference", "[gpu][contact]") {
  const Model model = slab_under_ball(0.5, 0.1);
  const SolverSettings settings = test::two_level();
  reference::NewtonSolver newton(model, settings);
  State state = initial_state(model);
  const double exact = drag_ratio(model, settings, [&] {
    newton.step(state);
    return newton.tool_loads().at(0).force;
  });
  const double drag = drag_on_gpu(model);
  CAPTURE(exact, drag);
  CHECK(drag == Approx(exact).epsilon(0.02));
}

}  // namespace
}  // namespace fascia
