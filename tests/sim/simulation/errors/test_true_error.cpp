// The comparison with the exact step: against an explicit run of the reference solver, at once and on a thread.
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/simulation/errors/true_error.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Scene cantilever(const std::vector<std::string>& sets) {
  return open_scene(source_dir() / "tests/reference/10_dynamic_cantilever/scene.json", sets);
}

}  // namespace

TEST_CASE("the true error is the distance to the reference solver's step") {
  Gpu gpu;
  Simulation simulation(cantilever({"solver.iterations=3"}), &gpu.programs, false);
  simulation.step();
  const State before = simulation.state();
  simulation.step();
  const std::vector<Vector3d> solved = simulation.state().displacement;
  TrueError measured;
  const StepError& error = measured.measure(simulation);

  State exact = before;
  reference::NewtonSolver(simulation.model, simulation.scene.solver).step(exact);
  const double h = simulation.scene.solver.substep();
  double squared = 0, scale = 0;
  const std::vector<char> held = simulation.model.held();
  for (std::size_t v = 0; v < solved.size(); ++v) {
    squared += (solved[v] - exact.displacement[v]).squaredNorm();
    if (!held[v])
      scale +=
          (exact.displacement[v] - before.displacement[v] - h * before.velocity[v] - h * h * simulation.model.gravity)
              .squaredNorm();
  }
  CHECK(error.converged);
  CHECK(error.relative == Approx(std::sqrt(squared / scale)).epsilon(1e-3));
  CHECK(error.relative > 1e-4);
  CHECK(error.step == simulation.gpu()->steps_solved());
  REQUIRE(error.distance.size() == solved.size());
  double largest = 0;
  for (std::size_t v = 0; v < solved.size(); ++v)
    largest = std::max(largest, (solved[v] - exact.displacement[v]).norm());
  CHECK(error.largest == Approx(largest).epsilon(1e-3));
}

TEST_CASE("the true error of a solved step is rounding, also with substeps and a grab") {
  Gpu gpu;
  const std::string integrator = GENERATE("implicit_euler", "bdf2", "sdirk2");
  CAPTURE(integrator);
  Simulation simulation(cantilever({"solver.iterations=300", "solver.substeps=2", "solver.integrator=" + integrator,
                                    "materials.default.damping=0.02"}),
                        &gpu.programs, false);
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < simulation.model.rest_positions.size(); v += 7)
    springs.push_back({v, {0.01, 0.02, 0}, 500});
  simulation.gpu()->set_grab(springs);
  for (int step = 0; step < 3; ++step) simulation.step();
  TrueError measured;
  const StepError& error = measured.measure(simulation);
  CAPTURE(error.relative, error.largest);
  CHECK(error.converged);
  CHECK(error.relative < 1e-4);
}

TEST_CASE("the true error is measured on a thread while steps continue") {
  Gpu gpu;
  Simulation simulation(cantilever({"solver.iterations=3"}), &gpu.programs, false);
  TrueError thread, at_once;
  CHECK_FALSE(thread.update(simulation, true));  // no step yet
  CHECK_FALSE(thread.busy());
  thread.request();
  simulation.step();
  const double expected = at_once.measure(simulation).relative;
  bool fresh = thread.update(simulation, false);
  simulation.set_settings([&] {  // later changes do not affect the step that is measured
    SolverSettings settings = simulation.scene.solver;
    settings.iterations = 20;
    return settings;
  }());
  for (int wait = 0; wait < 3000 && !fresh; ++wait) {
    CHECK(thread.busy());
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    simulation.step();
    fresh = thread.update(simulation, false);
  }
  REQUIRE(fresh);
  CHECK_FALSE(thread.busy());
  CHECK(thread.result()->relative == Approx(expected).epsilon(1e-9));
  thread.forget();
  CHECK_FALSE(thread.result());
}

TEST_CASE("a request that waits for a step is not pending: nothing needs to be drawn for it") {
  Gpu gpu;
  Simulation simulation(cantilever({}), &gpu.programs, false);
  TrueError error;
  error.request();
  error.update(simulation, false);  // no step yet
  CHECK(error.requested());
  CHECK_FALSE(error.busy());
  simulation.step();
  error.update(simulation, false);
  CHECK_FALSE(error.requested());
  CHECK(error.busy());
}

TEST_CASE("a pending measurement can be discarded") {
  Gpu gpu;
  Simulation simulation(cantilever({}), &gpu.programs, false);
  simulation.step();
  TrueError error;
  error.request();
  error.update(simulation, false);
  error.forget();
  CHECK_FALSE(error.busy());
  CHECK_FALSE(error.result());
}

TEST_CASE("a requested measurement tells the errors of solver, time step and mesh apart") {
  Gpu gpu;
  Simulation simulation(cantilever({"solver.iterations=3"}), &gpu.programs, false);
  for (int step = 0; step < 20; ++step) simulation.step();
  TrueError error;
  CHECK_FALSE(error.measure(simulation).time);  // only where requested
  error.request();
  bool fresh = error.update(simulation, false);
  const State start = simulation.state();
  for (int wait = 0; wait < 6000 && !fresh; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    fresh = error.update(simulation, false);
  }
  REQUIRE(fresh);
  const StepError& found = *error.result();
  REQUIRE(found.time);
  const MeshError mesh = estimate_mesh_error(simulation.model, start);

  // The truth of the next six steps: 16 substeps each.
  State coarse = start, exact = start;
  SolverSettings finer = simulation.scene.solver;
  finer.substeps = 16;
  reference::NewtonSolver in_use(simulation.model, simulation.scene.solver), fine(simulation.model, finer);
  for (int step = 0; step < TrueError::kFollowedSteps; ++step) {
    in_use.step(coarse);
    fine.step(exact);
  }
  const double in_time = relative_distance(coarse.displacement, exact.displacement);
  CAPTURE(found.of_displacement, found.time->relative, in_time, found.mesh, mesh.displacement);
  CHECK(found.of_displacement < 1e-3);
  CHECK(found.time->relative > 0.7 * in_time);
  CHECK(found.time->relative < 1.5 * in_time);
  CHECK(found.mesh == Approx(mesh.displacement).epsilon(1e-6));
  const double peak_in_time = peak_distance(simulation.model, coarse, exact);
  CAPTURE(peak_in_time, found.time->peak_stress, *found.peak_stress.solver);
  CHECK(found.time->peak_stress > 0.7 * peak_in_time);
  CHECK(found.time->peak_stress < 1.5 * peak_in_time);
  CHECK(*found.peak_stress.solver > 0);
  CHECK(*found.peak_stress.solver < 1e-2);
  CHECK(found.peak_stress.mesh == Approx(mesh.peak_stress).epsilon(1e-6));
}
