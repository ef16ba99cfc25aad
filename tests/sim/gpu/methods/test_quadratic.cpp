// Quadratic tets on the GPU, against the reference solver in double precision: one step of every law, motion, strain
// rates, heat maps, and what the GPU refuses.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/material/law.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model quadratic_bar(const Material& material) {
  return quadratic(
      make_model(make_box(4, 2, 2, {0.2, 0.06, 0.06}), material, [](const Vector3d& x) { return x.x() < 1e-9; }));
}

Model quadratic_bar(MaterialModel model, double poisson_ratio = 0.3, double damping = 0) {
  Material material{2e4, poisson_ratio, 1000, damping, model};
  return quadratic_bar(material);
}

SolverSettings settings_with(int iterations) {
  SolverSettings settings;
  settings.iterations = iterations;
  settings.rest_speed = 0;
  return settings;
}

double error_after(Gpu& gpu, const Model& model, const SolverSettings& settings, int steps) {
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  for (int k = 0; k < steps; ++k) {
    solver.step();
    const reference::NewtonReport report = reference.step(exact);
    CAPTURE(k, report.iterations, report.relative_residual);
    REQUIRE(report.converged);
  }
  return relative_rms(solver.download().displacement, exact.displacement);
}

}  // namespace

TEST_CASE("quadratic tets of every law follow the reference solver, damped or not", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const MaterialModel law = GENERATE(from_range(material_models()));
  const double damping = GENERATE(0.0, 0.02);
  Gpu gpu(loads);
  const double error = error_after(gpu, quadratic_bar(law, 0.3, damping), settings_with(60), 6);
  CAPTURE(name_of(law), damping, error);
  CHECK(error < 1e-6);  // a few roundings of float32
}

TEST_CASE("quadratic tets follow the reference solver with the default settings", "[gpu]") {
  const auto [nu, most] = GENERATE(table<double, double>({{0.0, 1e-4}, {0.3, 1e-4}, {0.45, 1.5e-3}, {0.49, 1e-2}}));
  const auto integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  Gpu gpu;
  SolverSettings settings = settings_with(10);
  settings.integrator = integrator;
  const double error = error_after(gpu, quadratic_bar(MaterialModel::squared, nu, 0.005), settings, 12);
  CAPTURE(nu, name_of(integrator), error);
  CHECK(error < most);
}

TEST_CASE("quadratic tets with two materials and a grab follow the reference solver", "[gpu]") {
  Gpu gpu;
  Model model = quadratic_bar(MaterialModel::signed_st_venant_kirchhoff);
  model.materials.push_back({2e5, 0.4, 1200, 0.01, MaterialModel::squared});
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material[t] = t % 3 == 0;
  const SolverSettings settings = settings_with(80);
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.2 - 1e-9) springs.push_back({v, {0.02, 0.03, 0.01}, 20});
  solver.set_grab(springs);
  reference.set_springs(springs);
  for (int k = 0; k < 6; ++k) {
    solver.step();
    REQUIRE(reference.step(exact).converged);
  }
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(error);
  CHECK(error < 2e-6);
}

TEST_CASE("diagnostics of quadratic tets are the reference solver's measures", "[gpu]") {
  Gpu gpu;
  const Model model = quadratic_bar(MaterialModel::squared, 0.4);
  GpuSolver solver(gpu.programs, model, settings_with(20));
  for (int k = 0; k < 8; ++k) solver.step();
  solver.request_diagnostics();
  const Diagnostics d = *solver.take_diagnostics(true);
  const reference::Measures exact = reference::measure(model, solver.download());
  CHECK(d.elastic == Approx(exact.elastic).epsilon(1e-4));
  CHECK(d.kinetic == Approx(exact.kinetic).epsilon(1e-4));
  CHECK(d.min_det_f == Approx(exact.min_det_f).epsilon(1e-4));
  CHECK(d.max_det_f == Approx(exact.max_det_f).epsilon(1e-4));
  CHECK(d.volume_ratio == Approx(exact.volume_ratio).epsilon(1e-5));
  CHECK(d.inverted == exact.inverted);
}

TEST_CASE("the GPU refuses methods and scenes that have no kernels for quadratic tets", "[gpu]") {
  Gpu gpu;
  Model model = quadratic_bar(MaterialModel::st_venant_kirchhoff);
  SolverSettings settings = settings_with(5);
  settings.method = Method::vertex_descent;
  settings.acceleration = Acceleration::none;
  CHECK_THROWS_WITH(
      GpuSolver(gpu.programs, model, settings),
      "solver.method: vertex_descent does not carry quadratic elements; expected two_level, or bodies with "
      "linear elements");
  model.mid_edges[3] = kNoMidEdges;
  CHECK_THROWS_WITH(
      GpuSolver(gpu.programs, model, settings_with(5)),
      "bodies.elements: is quadratic for some bodies and linear for others; expected the same for all, or "
      "the reference solver (run --reference)");
}
