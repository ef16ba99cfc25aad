// Covers: repeated_run
#include "sim/simulation/errors/time_error.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
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

// Boxes of few tets, by the reference solver.
std::unique_ptr<Simulation> after(const nlohmann::json& document, const TetMesh& mesh, int substeps, int steps) {
  Scene scene = read_scene_content("box", document.dump());
  scene.solver.substeps = substeps;
  auto simulation = std::make_unique<Simulation>(scene, build_model(scene, {mesh}), nullptr, true);
  for (int step = 0; step < steps; ++step) simulation->step();
  return simulation;
}

nlohmann::json box_scene(double young_modulus, double poisson_ratio, double damping, const std::string& integrator) {
  nlohmann::json scene{{"fascia_scene", 1}};
  scene["bodies"][0] = {{"mesh", "box"}};
  scene["bodies"][0]["materials"]["default"] = {
      {"young_modulus", young_modulus}, {"poisson_ratio", poisson_ratio}, {"density", 1000}, {"damping", damping}};
  scene["solver"] = {{"integrator", integrator}, {"rest_speed", 0}};
  return scene;
}

/// Twice the substeps and the integrator's order alone.
double by_nominal_order(const std::vector<Eigen::Vector3d>& coarse, const std::vector<Eigen::Vector3d>& fine,
                        int order) {
  const double gain = std::pow(2, order);
  return gain / (gain - 1) * relative_distance(coarse, fine);
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

// A block that falls on the ground and slides: BDF2 is of first order there.
TEST_CASE("the error in time of an impact is found, whose order is below that of the integrator") {
  nlohmann::json scene = box_scene(2e4, 0.4, 0.01, "bdf2");
  scene["bodies"][0]["transform"] = {{"rotate_deg", {10, 20, 30}}, {"translate", {0, 0.06, 0}}};
  scene["ground"] = {{"friction", 0.4}};
  const TetMesh block = make_box(3, 3, 3, {0.1, 0.1, 0.1});
  constexpr int kSteps = 60;
  const auto run = after(scene, block, 1, kSteps), twice = after(scene, block, 2, kSteps),
             exact = after(scene, block, 64, kSteps);
  const auto of = [](const auto& simulation) { return simulation->state().displacement; };
  const double error = relative_distance(of(run), of(exact));
  const TimeError estimate = estimate_time_error(*run, nullptr);
  CAPTURE(error, estimate.relative / error, estimate.order, estimate.resolved,
          by_nominal_order(of(run), of(twice), 2) / error);
  CHECK(estimate.relative > 0.5 * error);
  CHECK(estimate.relative < 2 * error);
}

// The bar vibrates about the hand's place without end; implicit Euler damps that in each of its runs.
TEST_CASE("the error in time under a hand without damping is a bound where steps do not resolve the vibration") {
  const std::string integrator = GENERATE("implicit_euler", "bdf2");
  nlohmann::json scene = box_scene(1e5, 0.3, 0, integrator);
  scene["gravity"] = {0, 0, 0};
  scene["bodies"][0]["fixed"] = {{{"box", {{-1, -1, -1}, {0.001, 1, 1}}}}};
  scene["grabs"][0] = {{"select", {{"box", {{0.199, -1, -1}, {1, 1, 1}}}}},
                       {"translate", {0.03, 0.06, 0}},
                       {"stiffness", 2000},
                       {"duration", 0.2}};
  const TetMesh bar = make_box(4, 1, 1, {0.2, 0.05, 0.05});
  constexpr int kSteps = 40;
  const auto run = after(scene, bar, 1, kSteps), twice = after(scene, bar, 2, kSteps);
  scene["solver"]["integrator"] = "sdirk2";
  const auto exact = after(scene, bar, 64, kSteps);
  const auto of = [](const auto& simulation) { return simulation->state().displacement; };
  const double error = relative_distance(of(run), of(exact));
  const TimeError estimate = estimate_time_error(*run, nullptr);
  CAPTURE(integrator, error, estimate.relative / error, estimate.order,
          by_nominal_order(of(run), of(twice), 1) / error);
  CHECK_FALSE(estimate.resolved);
  CHECK(estimate.relative > 0.5 * error);
}

// A block that settles under its weight vibrates without end; implicit Euler damps that within the first of its steps,
// however often they are halved.
TEST_CASE("the error in time where all steps damp the vibration of a block away is a bound") {
  nlohmann::json scene = box_scene(2e4, 0.3, 0, "implicit_euler");
  scene["gravity"] = {0, -9.81, 0};
  scene["bodies"][0]["fixed"] = {{{"lowest", 0.02}}};
  const TetMesh block = make_box(3, 3, 3, {0.03, 0.03, 0.03});
  constexpr int kMoments = 10, kSteps = 3;  // between moments
  const auto run = after(scene, block, 1, 0);
  scene["solver"]["integrator"] = "sdirk2";
  const auto exact = after(scene, block, 64, 0);
  double squares = 0, whole = 0;
  for (int moment = 0; moment < kMoments; ++moment) {
    for (int step = 0; step < kSteps; ++step) run->step(), exact->step();
    const State now = run->state(), truth = exact->state();
    for (std::size_t v = 0; v < truth.displacement.size(); ++v) {
      squares += (now.displacement[v] - truth.displacement[v]).squaredNorm();
      whole += truth.displacement[v].squaredNorm();
    }
  }
  const double error = std::sqrt(squares / whole);
  const TimeError estimate = estimate_time_error(*run, nullptr);
  CAPTURE(error, estimate.over_run / error, estimate.order);
  CHECK_FALSE(estimate.resolved);
  CHECK(estimate.over_run > 0.5 * error);
}

TEST_CASE("a run without steps has no error in time") {
  Gpu gpu;
  const Simulation still(cantilever("implicit_euler", 1), &gpu.programs, false);
  CHECK(estimate_time_error(still, &gpu.programs).relative == 0);
}

TEST_CASE("a replay is repeated with its inputs") {
  Gpu gpu;
  constexpr long kSteps = 20;
  const auto replay_with = [&](int substeps) {
    Replay replay;
    replay.scene = cantilever("implicit_euler", substeps);
    SolverSettings finer = replay.scene.solver;
    finer.substeps = 2 * substeps;
    replay.inputs = {{2, GravityInput{{0, -20, 5}}}, {10, finer}};
    replay.steps = kSteps;
    auto simulation = std::make_unique<Simulation>(replay.scene, &gpu.programs, false);
    simulation->play(std::move(replay));
    return simulation;
  };
  TimeExtrapolation extrapolation(1);
  for (int substeps = 1; extrapolation.wants_more(); substeps *= 2) {
    Trajectory motion;
    const auto simulation = replay_with(substeps);
    for (long step = 1; step <= kSteps; ++step) {
      simulation->step();
      if (step % 2 == 0) motion.displacement.push_back(simulation->state().displacement);
    }
    extrapolation.add(std::move(motion));
  }
  const auto run = replay_with(1);
  for (long step = 0; step < kSteps; ++step) run->step();
  const TimeError expected = extrapolation.error(), found = estimate_time_error(*run, &gpu.programs);
  CHECK(expected.relative > 0.01);
  CHECK(found.relative == Approx(expected.relative).epsilon(1e-12));
  CHECK(found.over_run == Approx(expected.over_run).epsilon(1e-12));
}

TEST_CASE("the repetition of a run ends when it is stopped") {
  Gpu gpu;
  const auto simulation = after(gpu, "bdf2", 1, 3);
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(estimate_time_error(*simulation, &gpu.programs, stop.get_token()).complete);
}
