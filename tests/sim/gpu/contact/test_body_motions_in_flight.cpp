// Bodies that fly go on as wholes: they keep their momentum, and turn on as by exact steps.

#include <catch2/catch.hpp>

#include "sim/gpu/contact/body_motions.h"
#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// A bar that nothing holds, beside one that is held, and a smaller one, heavier and stiffer, that nothing holds either.
Model three_bars(bool of_quadratic) {
  const Material soft{2e4, 0.3, 1000, 0, MaterialModel::squared}, hard{2e5, 0.45, 3000, 0, MaterialModel::squared};
  const auto at_end = [](const Vector3d& x) { return x.x() < 1e-9; };
  const auto nowhere = [](const Vector3d&) { return false; };
  const Model held = make_model(make_box(4, 2, 2, {0.2, 0.1, 0.1}), soft, at_end),
              small = make_model(make_box(3, 2, 2, {0.1, 0.05, 0.05}), hard, nowhere);
  Model model = beside(make_model(make_box(8, 4, 4, {0.2, 0.1, 0.1}), soft, nowhere), moved(held, {0, 0.3, 0}), "held");
  model = beside(model, moved(small, {0, 0.6, 0}), "small");
  model.contact.bodies = false;
  if (of_quadratic) model = quadratic(std::move(model));
  model.gravity = {0, -9.81, 0};
  const UnconstrainedParts free = unconstrained_parts(model, model.held());
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    const Vector3d& x = model.rest_positions[v];
    if (free.part[v] > 0)  // bends, shears and turns
      model.initial_velocity[v] = {1 + 8 * (x.y() > 0.5 ? x.y() - 0.6 : x.y()), 20 * (x.x() - 0.1) * (x.x() - 0.1),
                                   5 * x.x() + 0.5};
  }
  return model;
}

}  // namespace

// Three iterations alone change momenta by 8e-5 to 2e-3, in quadratic tets by SDIRK2 by all of them. What is left is
// the rounding of displacements, which gravity makes a meter long, over the length of a stage.
TEST_CASE("what nothing holds keeps its momentum in unfinished iterations", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const bool of_quadratic = GENERATE(false, true);
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  Gpu gpu(loads);
  const Model model = three_bars(of_quadratic);
  SolverSettings settings;
  settings.integrator = integrator;
  settings.iterations = 3;
  GpuSolver solver(gpu.programs, model, settings);
  const UnconstrainedParts free = unconstrained_parts(model, model.held());
  REQUIRE(free.parts == 2);
  const std::vector<double> masses = consistent_masses(model);
  for (int k = 0; k < 30; ++k) solver.step();
  const State state = solver.download();
  for (std::uint32_t part = 1; part <= 2; ++part) {
    Vector3d expected(0, 0, 0), found(0, 0, 0);
    for (std::size_t v = 0; v < masses.size(); ++v)
      if (free.part[v] == part) {
        expected += masses[v] * (model.initial_velocity[v] + 30 * settings.time_step * model.gravity);
        found += masses[v] * state.velocity[v];
      }
    CAPTURE(gl::name_of(loads), of_quadratic, name_of(integrator), part, expected.transpose(), found.transpose());
    CAPTURE((found - expected).norm() / expected.norm());
    CHECK((found - expected).norm() < 2e-5 * expected.norm());
  }
}

// Three iterations alone leave a sixth of the energy that this cube has after half a second by exact steps.
TEST_CASE("what nothing holds turns on in unfinished iterations", "[gpu]") {
  const bool of_quadratic = GENERATE(false, true);
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2);
  Gpu gpu;
  Model model = make_model(make_box(3, 3, 3, {0.06, 0.06, 0.06}), Material{3e5, 0.3, 1000, 0, MaterialModel::squared},
                           [](const Vector3d&) { return false; });
  if (of_quadratic) model = quadratic(std::move(model));
  const Vector3d spin(3, 15, -6);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    model.initial_velocity[v] = spin.cross(model.rest_positions[v] - Vector3d(0.03, 0.03, 0.03));
  model.gravity.setZero();
  SolverSettings settings;
  settings.integrator = integrator;
  settings.iterations = 3;
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver newton(model, settings);
  State exact = initial_state(model);
  for (int k = 0; k < 30; ++k) {
    solver.step();
    newton.step(exact);
  }
  const std::vector<double> masses = consistent_masses(model);
  const auto energy_of = [&](const State& state) {
    double energy = 0;
    for (std::size_t v = 0; v < masses.size(); ++v) energy += 0.5 * masses[v] * state.velocity[v].squaredNorm();
    return energy;
  };
  const double found = energy_of(solver.download()), expected = energy_of(exact),
               begun = energy_of(initial_state(model));
  CAPTURE(of_quadratic, name_of(integrator), found / begun, expected / begun);
  CHECK(found == Approx(expected).epsilon(0.05));
}

// One bar is to turn by 2 rad, which takes several passes, the other to move only.
TEST_CASE("a body that turns far holds no other back", "[gpu]") {
  Gpu gpu;
  const auto bar = [](double x) {
    return moved(make_model(make_box(2, 1, 1, {0.1, 0.05, 0.05}), Material{}, [](const Vector3d&) { return false; }),
                 {x, 0, 0});
  };
  const Model model = beside(bar(0), bar(1), "second");
  const SimBuffers buffers(model);
  BodyMotions motions(model, buffers);
  motions.begin({});
  const std::uint32_t second = model.bodies[1].vertex_begin;
  const Vector3d way(0.01, -0.02, 0.03), middle(0.05, 0.025, 0.025);
  std::vector<Vector3d> wanted(model.rest_positions.size(), way), u(wanted.size(), Vector3d::Zero());
  for (std::uint32_t v = 0; v < second; ++v) {
    const Vector3d arm = model.rest_positions[v] - middle;
    wanted[v] += Eigen::AngleAxisd(2, Vector3d::UnitY()) * arm - arm;
  }
  REQUIRE(motions.move(nullptr, wanted, 1.0 / 60, u));
  for (std::uint32_t v = second; v < u.size(); ++v) {
    CAPTURE(v, u[v].transpose(), way.transpose());
    REQUIRE((u[v] - way).norm() < 1e-6 * way.norm());
  }
}
