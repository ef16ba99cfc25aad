// The loads of contact over a step are what changes the momentum of bodies in it, however many substeps and stages make
// it up, by both solvers; and so is the force of one body on another.
// Covers: contact_readout
#include <catch2/catch.hpp>

#include "sim/contact/pair_energy.h"
#include "sim/gpu/solver.h"
#include "sim/model/model.h"
#include "sim/reference/newton.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

SolverSettings in_stages(Integrator integrator, int substeps) {
  SolverSettings settings = test::two_level();
  settings.integrator = integrator;
  settings.substeps = substeps;
  settings.rest_speed = 0;
  return settings;
}

// Of the vertices from `first` on [kg m/s].
Vector3d momentum(const Model& model, const State& state, std::size_t first = 0) {
  const std::vector<double> mass = consistent_masses(model);
  Vector3d sum(0, 0, 0);
  for (std::size_t v = first; v < mass.size(); ++v) sum += mass[v] * state.velocity[v];
  return sum;
}

double mass_of(const Model& model, std::size_t first = 0) {
  double sum = 0;
  const std::vector<double> mass = consistent_masses(model);
  for (std::size_t v = first; v < mass.size(); ++v) sum += mass[v];
  return sum;
}

}  // namespace

TEST_CASE("forces over a step are its impulses", "[gpu][contact]") {
  const auto [integrator, substeps] = GENERATE(table<Integrator, int>({{Integrator::implicit_euler, 1},
                                                                       {Integrator::implicit_euler, 4},
                                                                       {Integrator::sdirk2, 1},
                                                                       {Integrator::sdirk2, 3}}));
  const bool on_tissue = GENERATE(false, true);
  CAPTURE(name_of(integrator), substeps, on_tissue);
  const Model block = test::cube(0.1, 3, test::soft_tissue(1e5));
  Model model = test::moved(block, {0, 0.003, 0});
  std::size_t first = 0;  // vertex of the body that falls
  if (on_tissue) {
    const Model base = test::make_model(make_box(4, 1, 4, {0.14, 0.05, 0.14}), test::soft_tissue(1e5),
                                        [](const Vector3d& x) { return x.y() < 1e-9; });
    model = test::beside(base, test::moved(block, {0.02, 0.056, 0.02}), "block");
    model.contact.friction = 0.3;
    first = base.rest_positions.size();
  } else {
    model.tools = {test::tool("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}}, 0.3)};
  }
  model.gravity = {0.5, -9.81, 0};
  const SolverSettings settings = in_stages(integrator, substeps);
  const double step = settings.time_step, mass = mass_of(model, first);
  test::Gpu gpu;
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver newton(model, settings);
  State exact = initial_state(model);
  const auto impulse = [&](const std::vector<ToolLoad>& tools, const std::vector<PairLoad>& pairs) -> Vector3d {
    return step * (on_tissue ? load_between(pairs, {0, 1}).force : tools[0].force);
  };
  Vector3d before = momentum(model, solver.download(), first), exact_before = before;
  double worst = 0, exact_worst = 0, largest = 0;
  for (int i = 0; i < 30; ++i) {
    solver.step();
    newton.step(exact);
    solver.request_diagnostics();
    const Diagnostics d = *solver.take_diagnostics(true);
    const Vector3d now = momentum(model, solver.download(), first), exact_now = momentum(model, exact, first);
    const Vector3d weight = step * mass * model.gravity;
    worst = std::max(worst, (now - before - weight - impulse(d.tool_loads, d.pair_loads)).norm());
    exact_worst = std::max(
        exact_worst, (exact_now - exact_before - weight - impulse(newton.tool_loads(), newton.pair_loads())).norm());
    largest = std::max(largest, impulse(newton.tool_loads(), newton.pair_loads()).norm());
    before = now;
    exact_before = exact_now;
  }
  CAPTURE(worst, exact_worst, largest, step * mass * 9.81);
  CHECK(largest > 1.5 * step * mass * 9.81);  // that of a hit
  CHECK(exact_worst < 1e-9 * largest);
  CHECK(worst < 1e-4 * largest);
}

}  // namespace fascia
