// Contact with tissue that supports hold: they bear what presses on it.
// Covers: contact_readout
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// All supports together.
Vector3d sum_of(const std::vector<reference::Support>& supports) {
  Vector3d sum(0, 0, 0);
  for (const reference::Support& support : supports) sum += support.force;
  return sum;
}

}  // namespace

TEST_CASE("supports of a body that another one lies on bear the weight of both", "[gpu][contact]") {
  test::Gpu gpu;
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::sdirk2);
  const double held_below = GENERATE(1.0, 0.04);  // all of it, or all but its top
  const Material tissue = test::soft_tissue(2e4, 0.05);
  const Model base = test::make_model(make_box(3, 2, 3, {0.1, 0.06, 0.1}), tissue,
                                      [&](const Vector3d& x) { return x.y() < held_below - 1e-9; });
  Model model = test::beside(base, test::moved(test::cube(0.06, 2, tissue), {0.02, 0.0605, 0.02}), "block");
  model.gravity = {0, -9.81, 0};
  model.contact.friction = 0.5;
  const Vector3d weight = 1000 * (0.1 * 0.06 * 0.1 + 0.06 * 0.06 * 0.06) * model.gravity;
  GpuSolver solver(gpu.programs, model, test::awake(integrator));
  reference::NewtonSolver newton(model, test::awake(integrator));
  State exact = initial_state(model);
  for (int i = 0; i < 120; ++i) solver.step();
  for (int i = 0; i < 60; ++i) newton.step(exact);
  solver.request_diagnostics();
  const Diagnostics d = *solver.take_diagnostics(true);
  const State state = solver.download();
  const Vector3d by_state = reference::measure(model, state, solver.contact_forces()).fixed_reaction,
                 by_supports = sum_of(reference::support_forces(model, state, solver.contact_forces())),
                 by_reference = reference::measure(model, exact, newton.contact_forces()).fixed_reaction;
  CAPTURE(name_of(integrator), held_below, weight.transpose(), d.reaction.transpose(), by_state.transpose(),
          by_supports.transpose(), by_reference.transpose(), d.imbalance(weight));
  CHECK((d.reaction + weight).norm() < 0.01 * weight.norm());
  CHECK((by_state - d.reaction).norm() < 1e-3 * weight.norm());
  CHECK((by_supports - by_state).norm() < 1e-9 * weight.norm());
  CHECK((by_reference + weight).norm() < 0.01 * weight.norm());
  CHECK(d.imbalance(weight) < 1e-3);
}

TEST_CASE("supports bear what a tool presses on faces that they hold in part", "[gpu][contact]") {
  test::Gpu gpu;
  constexpr double kSize = 0.1, kDepth = 0.01, kHalf = 0.02;
  Model model = test::make_model(make_box(4, 4, 4, {kSize, kSize, kSize}), test::soft_tissue(1e4, 0.05),
                                 [](const Vector3d& x) { return x.x() < 0.03 || x.y() < 1e-9; });
  model.gravity.setZero();
  const double top = kSize + kHalf;
  model.tools = {test::tool("punch", BoxShape{{0, 0, 0}, {kHalf, kHalf, kHalf}, 0.005}, 0.3,
                            {{0, {0.04, top, 0.05}, {0, 0, 0}}, {0.3, {0.04, top - kDepth, 0.05}, {0, 0, 0}}})};
  GpuSolver solver(gpu.programs, model, test::awake(Integrator::implicit_euler));
  for (int i = 0; i < 90; ++i) solver.step();
  solver.request_diagnostics();
  const Diagnostics d = *solver.take_diagnostics(true);
  const State state = solver.download();
  const std::vector<Vector3d> contact = solver.contact_forces();
  double on_held = 0;
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (held[v]) on_held += contact[v].norm();
  const Vector3d of_tool = d.tool_loads[0].force;
  const Vector3d by_state = reference::measure(model, state, contact).fixed_reaction;
  CAPTURE(of_tool.transpose(), d.reaction.transpose(), by_state.transpose(), on_held);
  REQUIRE(on_held > 0.1 * of_tool.norm());
  CHECK((d.reaction + of_tool).norm() < 2e-3 * of_tool.norm());
  CHECK((by_state + of_tool).norm() < 2e-3 * of_tool.norm());
}

// Forces of supports that oppose each other cancel, and rounding would seem to be all that there is.
TEST_CASE("the imbalance of forces is over the largest single one", "[diagnostics]") {
  Diagnostics d;
  d.reaction = {0, 1e-4, 0};
  CHECK(d.imbalance({0, 0, 0}) == Approx(1));
  CHECK(d.imbalance({0, 0, 0}, 2) == Approx(5e-5));
  d.tool_loads = {ToolLoad{}, ToolLoad{}};
  d.tool_loads[1].force = {0, 0, 4};
  CHECK(d.imbalance({0, 0, 0}, 2) == Approx(2.5e-5));
  d.grab_forces = {{}};
  d.grab_forces[0].force = {10, 0, 0};
  CHECK(d.imbalance({0, 0, 0}, 2) == Approx(1e-5));
}

}  // namespace fascia
