#include "sim/simulation/time_error.h"

#include <catch2/catch.hpp>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/relative_distance.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Scene cantilever(const std::string& integrator, int substeps) {
  return open_scene(source_dir() / "tests/reference/10_dynamic_cantilever/scene.json",
                    {"solver.integrator=" + integrator, "solver.substeps=" + std::to_string(substeps)});
}

std::unique_ptr<Simulation> after(Gpu& gpu, const std::string& integrator, int substeps, int steps) {
  auto simulation = std::make_unique<Simulation>(cantilever(integrator, substeps), &gpu.programs, false);
  for (int step = 0; step < steps; ++step) simulation->step();
  return simulation;
}

}  // namespace

// The truth: the same motion with steps 16 times as short, by BDF2.
TEST_CASE("the estimated error in time is 0.7 to 1.5 of the error against many substeps") {
  Gpu gpu;
  const std::string integrator = GENERATE("implicit_euler", "bdf2", "sdirk2");
  constexpr int kSteps = 20;
  const auto coarse = after(gpu, integrator, 1, kSteps), exact = after(gpu, "bdf2", 16, kSteps);
  const double error = relative_distance(coarse->state().displacement, exact->state().displacement),
               peak = peak_distance(coarse->model, coarse->state(), exact->state());
  const TimeError estimate = estimate_time_error(*coarse, &gpu.programs);
  CAPTURE(integrator, error, estimate.relative / error, peak, estimate.peak_stress / peak);
  CHECK(estimate.relative > 0.7 * error);
  CHECK(estimate.relative < 1.5 * error);
  CHECK(estimate.peak_stress > 0.7 * peak);
  CHECK(estimate.peak_stress < 1.5 * peak);
}

TEST_CASE("a run without steps has no error in time") {
  Gpu gpu;
  const Simulation still(cantilever("implicit_euler", 1), &gpu.programs, false);
  CHECK(estimate_time_error(still, &gpu.programs).relative == 0);
}

TEST_CASE("a replay is repeated with its inputs") {
  Gpu gpu;
  const auto replay_with = [&](int substeps) {
    Replay replay;
    replay.scene = cantilever("implicit_euler", substeps);
    SolverSettings finer = replay.scene.solver;
    finer.substeps = 2 * substeps;
    replay.inputs = {{2, GravityInput{{0, -20, 5}}}, {10, finer}};
    replay.steps = 20;
    auto simulation = std::make_unique<Simulation>(replay.scene, &gpu.programs, false);
    simulation->play(std::move(replay));
    for (int step = 0; step < 20; ++step) simulation->step();
    return simulation;
  };
  const auto coarse = replay_with(1), fine = replay_with(2);
  const double distance = relative_distance(coarse->state().displacement, fine->state().displacement);
  CHECK(distance > 0.01);
  CHECK(estimate_time_error(*coarse, &gpu.programs).relative == Approx(2 * distance).epsilon(1e-12));
}

TEST_CASE("the repetition of a run ends when it is stopped") {
  Gpu gpu;
  const auto simulation = after(gpu, "bdf2", 1, 3);
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(estimate_time_error(*simulation, &gpu.programs, stop.get_token()).complete);
}
