// solver.tolerance: iterations end on the GPU exactly when the residual of the diagnostics is small enough.
#include <algorithm>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

double residual_of(GpuSolver& solver) {
  solver.request_diagnostics();
  return solver.take_diagnostics(true)->residual;
}

std::vector<GrabSpring> grip(const Model& model, double stiffness = 40) {
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.19) springs.push_back({v, {0.02, 0.03, 0}, stiffness});
  return springs;
}

}  // namespace

TEST_CASE("a tolerance ends the iterations at the first one that meets it", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const SolverChoice pair = GENERATE(SolverChoice{Method::two_level, Acceleration::nonlinear_cg},
                                     SolverChoice{Method::two_level, Acceleration::subspace},
                                     SolverChoice{Method::two_level, Acceleration::anderson});
  const bool grabbed = GENERATE(false, true);
  Gpu gpu(loads);
  const Model model = bar(GENERATE(0.0, 0.02));
  SolverSettings settings = with(pair);
  settings.iterations = 100;
  settings.tolerance = 1e-3;
  GpuSolver stopped(gpu.programs, model, settings);
  const auto step = [&](GpuSolver& solver, int times) {
    if (grabbed) solver.set_grab(grip(model));
    for (int k = 0; k < times; ++k) solver.step();
  };
  step(stopped, 1);
  const int used = stopped.last_iterations();
  CAPTURE(name_of(pair.acceleration), grabbed, used);
  CHECK(used > 1);
  CHECK(used < 100);
  CHECK(stopped.mean_iterations() == used);
  CHECK(residual_of(stopped) <= 1.001e-3);
  stopped.request_diagnostics();
  CHECK(stopped.take_diagnostics(true)->iterations == used);

  // The same number of iterations without a tolerance gives the same state; one less does not meet it. A step with few
  // remaining iterations omits the last refresh: then only the gain of the iterations after it differs.
  bool saved = false;
  for (int i = 0; i < used; ++i)
    saved |= StepMethod::refreshes_before(i, settings.iterations) && !StepMethod::refreshes_before(i, used);
  CAPTURE(saved);
  settings.tolerance = 0;
  settings.iterations = used;
  GpuSolver counted(gpu.programs, model, settings);
  step(counted, 1);
  CHECK(relative_rms(stopped.download().displacement, counted.download().displacement) < (saved ? 1e-4 : 1e-6));
  settings.iterations = used - 1;
  GpuSolver fewer(gpu.programs, model, settings);
  step(fewer, 1);
  CHECK(residual_of(fewer) > 0.999e-3);

  // Steps after the first have their own counts.
  step(stopped, 4);
  CHECK(stopped.last_iterations() < 100);
  CHECK(residual_of(stopped) <= 1.001e-3);
}

TEST_CASE("a tolerance out of reach changes nothing", "[gpu]") {
  Gpu gpu;
  const SolverChoice pair = any_pair();
  const Model model = bar();
  SolverSettings settings = with(pair);
  settings.iterations = 11;
  settings.substeps = 2;
  GpuSolver free(gpu.programs, model, settings);
  settings.tolerance = 1e-9;
  GpuSolver bound(gpu.programs, model, settings);
  for (GpuSolver* solver : {&free, &bound}) {
    solver->set_grab(grip(model, 2));  // the limit of exact_xpbd with so few iterations
    for (int k = 0; k < 2; ++k) solver->step();
  }
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  CHECK(bound.last_iterations() == 11);
  CHECK(bound.mean_iterations() == 11);
  CHECK(relative_rms(bound.download().displacement, free.download().displacement) == 0);
}

TEST_CASE("methods without a gradient of their own are checked every eighth iteration", "[gpu]") {
  Gpu gpu;
  const Method method =
      GENERATE(Method::mass_splitting, Method::gauss_seidel, Method::exact_xpbd, Method::vertex_descent);
  Model model = bar();
  for (Material& material : model.materials) material.young_modulus = 2e3;
  SolverSettings settings = with(method);
  settings.time_step = 1.0 / 500;
  settings.iterations = 200;
  settings.tolerance = 0.05;
  GpuSolver solver(gpu.programs, model, settings);
  solver.step();
  CAPTURE(name_of(method), solver.last_iterations(), residual_of(solver));
  CHECK(solver.last_iterations() < 200);
  CHECK(solver.last_iterations() % StopRule::kOwnInterval == 0);
  CHECK(residual_of(solver) <= 0.0501);
}

TEST_CASE("a body at rest takes no iterations", "[gpu]") {
  Gpu gpu;
  const Model model = free_bar();
  SolverSettings settings;
  settings.tolerance = 1e-4;
  GpuSolver solver(gpu.programs, model, settings);
  for (int k = 0; k < 3; ++k) solver.step();
  CHECK(solver.last_iterations() == 0);
  CHECK(solver.mean_iterations() == 0);
  for (const Vector3d& u : solver.download().displacement) CHECK(u.norm() == 0);

  // After an input it needs some again; without the tolerance, all.
  solver.set_grab(grip(model));
  solver.step();
  CHECK(solver.last_iterations() > 0);
  settings.tolerance = 0;
  solver.set_settings(settings);
  CHECK(solver.mean_iterations() == settings.iterations);
}
