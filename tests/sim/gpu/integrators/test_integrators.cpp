// Whole steps of the integrators that extrapolate, against the reference solver in double precision, and what they
// remember across steps, states and settings.
#include <catch2/catch.hpp>
#include <cstring>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using shared::vec4;

namespace {

SolverSettings exact_enough(Integrator integrator) {
  SolverSettings settings;
  settings.integrator = integrator;
  settings.iterations = 60;
  settings.rest_speed = 0;
  return settings;
}

// The free end of the bar is turned by half a radian within the first 0.1 s.
Model turned_bar(double damping) {
  Model model = bar(damping);
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.2 - 1e-9) motion.vertices.push_back(v);
  motion.angle = 0.5;
  motion.center = {0.2, 0.03, 0.03};
  motion.duration = 0.1;
  model.motions.push_back(motion);
  return model;
}

bool equal_bits(const GpuSolver& a, const GpuSolver& b) {
  const auto x = a.buffers().displacement.read<vec4>(), y = b.buffers().displacement.read<vec4>();
  const auto v = a.buffers().velocity.read<vec4>(), w = b.buffers().velocity.read<vec4>();
  return std::memcmp(x.data(), y.data(), x.size() * sizeof(vec4)) == 0 &&
         std::memcmp(v.data(), w.data(), v.size() * sizeof(vec4)) == 0;
}

}  // namespace

TEST_CASE("steps of every integrator follow the reference solver", "[gpu]") {
  const Integrator integrator = GENERATE(Integrator::bdf2, Integrator::sdirk2);
  const double damping = GENERATE(0.0, 0.02);
  const bool turned = GENERATE(false, true);
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const Model model = turned ? turned_bar(damping) : bar(damping);
  SolverSettings settings = exact_enough(integrator);
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  const auto run = [&](int steps) {
    reference::NewtonSolver reference(model, settings);
    for (int k = 0; k < steps; ++k) {
      solver.step();
      REQUIRE(reference.step(exact).converged);
    }
  };
  run(8);
  settings.time_step /= 1.5;  // BDF2 goes on with uneven steps
  settings.substeps = 2;
  solver.set_settings(settings);
  run(4);
  const State state = solver.download();
  const double error = relative_rms(state.displacement, exact.displacement),
               speed_error = relative_rms(state.velocity, exact.velocity);
  CAPTURE(name_of(integrator), damping, turned, error, speed_error);
  CHECK(state.time == Approx(exact.time).epsilon(1e-12));
  CHECK(error < 1e-5);
  CHECK(speed_error < 2e-4);  // differences of displacements over a stage
}

TEST_CASE("what nothing holds falls as it should in short steps", "[gpu]") {
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  Gpu gpu;
  Model model = bar();
  model.fixed.clear();
  if (GENERATE(false, true)) model = quadratic(model);
  SolverSettings settings;
  settings.integrator = integrator;
  settings.substeps = 64;
  settings.iterations = 3;
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  constexpr int kSteps = 20;
  for (int k = 0; k < kSteps; ++k) solver.step();
  const Vector3d expected = kSteps * settings.time_step * model.gravity;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& v : solver.download().velocity) mean += v / static_cast<double>(model.rest_positions.size());
  const double error = (mean - expected).norm() / expected.norm();
  CAPTURE(name_of(integrator), model.has_quadratic(), error);
  CHECK(error < 1e-3);
}

TEST_CASE("vibrations of a hundred-thousandth of the size are those of the reference solver", "[gpu]") {
  const MaterialModel law = GENERATE(MaterialModel::squared, MaterialModel::neo_hookean,
                                     MaterialModel::stable_neo_hookean, MaterialModel::mooney_rivlin);
  Gpu gpu;
  Model model = bar();
  for (Material& material : model.materials) material.model = law;
  if (GENERATE(false, true)) model = quadratic(model);
  model.gravity = {0, -9.81e-4, 0};
  SolverSettings settings;
  settings.integrator = Integrator::sdirk2;
  settings.time_step = 1e-3;
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver reference(model, settings);
  State exact = initial_state(model);
  for (int k = 0; k < 60; ++k) {
    solver.step();
    REQUIRE(reference.step(exact).converged);
  }
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(name_of(law), model.has_quadratic(), error);
  CHECK(error < 1e-4);  // with energies from the gradient of displacements 1.5e-3
}

TEST_CASE("methods of the paper take any integrator", "[gpu]") {
  const Integrator integrator = GENERATE(Integrator::bdf2, Integrator::sdirk2);
  Gpu gpu;
  const Model model = bar();
  SolverSettings settings = exact_enough(integrator);
  settings.method = Method::gauss_seidel;
  settings.acceleration = Acceleration::none;
  settings.iterations = 400;
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  for (int k = 0; k < 10; ++k) {
    solver.step();
    reference.step(exact);
  }
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(name_of(integrator), error);
  CHECK(error < 0.02);  // XPBD leaves out the second derivatives of its constraints
}

TEST_CASE("BDF2 goes on to the bit from a downloaded state, from the kept one and in another solver", "[gpu]") {
  Gpu gpu;
  const Model model = bar(0.02);
  const SolverSettings settings = exact_enough(Integrator::bdf2);
  GpuSolver solver(gpu.programs, model, settings), other(gpu.programs, model, settings),
      follower(gpu.programs, model, settings);
  for (int k = 0; k < 5; ++k) solver.step();
  const State state = solver.download();
  REQUIRE(state.earlier.step == settings.substep());
  CHECK(relative_rms(state.earlier.displacement, state.displacement) > 0.01);
  other.upload(state);
  follower.follow(solver);
  solver.request_check();
  REQUIRE(solver.take_check(true));
  const State kept = solver.download_valid();
  CHECK(kept.earlier.displacement == state.earlier.displacement);
  for (int k = 0; k < 3; ++k)
    for (GpuSolver* each : {&solver, &other, &follower}) each->step();
  CHECK(equal_bits(solver, other));
  CHECK(equal_bits(solver, follower));
  solver.restore_valid(false);
  for (int k = 0; k < 3; ++k) solver.step();
  CHECK(equal_bits(solver, other));
  solver.restore_valid(true);
  CHECK(solver.download().earlier.step == 0);  // a state at rest has no earlier motion
}

TEST_CASE("implicit Euler keeps nothing of an earlier step", "[gpu]") {
  Gpu gpu;
  const Model model = bar();
  SolverSettings settings = exact_enough(Integrator::implicit_euler);
  GpuSolver solver(gpu.programs, model, settings);
  for (int k = 0; k < 2; ++k) solver.step();
  CHECK(solver.download().earlier.step == 0);
  CHECK_FALSE(solver.buffers().earlier_displacement);
  const auto dispatches = solver.dispatches_per_step();
  settings.integrator = Integrator::bdf2;
  solver.set_settings(settings);
  CHECK(solver.dispatches_per_step() == dispatches);
  CHECK(solver.buffers().earlier_displacement);
  settings.integrator = Integrator::sdirk2;
  solver.set_settings(settings);
  CHECK(solver.dispatches_per_step() == 2 * dispatches);
  settings.integrator = Integrator::implicit_euler;
  solver.set_settings(settings);
  CHECK_FALSE(solver.buffers().earlier_displacement);
}
