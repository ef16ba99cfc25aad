#include "sim/simulation/errors/mesh_error_in_motion.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sim/accuracy/mesh_error.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/errors/solver_error.h"
#include "sim/simulation/errors/time_error.h"
#include "sim/simulation/errors/true_error.h"
#include "sim/simulation/static_equilibrium.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kStepsOfMotion = 30;
const Eigen::Vector3d kBar(0.3, 0.1, 0.1);

// A bar of 0.3 m, at least as stiff as gravity needs to bend it by a fifth of its length.
nlohmann::json scene_of_bar(const std::string& elements) {
  nlohmann::json scene{{"fascia_scene", 1}};
  nlohmann::json& body = scene["bodies"][0];
  body = {{"mesh", "bar"}, {"elements", elements}};
  body["materials"]["default"] = {
      {"young_modulus", 5e5}, {"poisson_ratio", 0.4}, {"density", 1000}, {"damping", 0.002}};
  body["fixed"] = {{{"box", {{-1, -1, -1}, {0.001, 1, 1}}}}};
  scene["solver"] = {{"integrator", "bdf2"}, {"substeps", 2}, {"iterations", 15}, {"rest_speed", 0}};
  return scene;
}

std::unique_ptr<Simulation> bar_of(Gpu& gpu, const nlohmann::json& document, int cells) {
  const Scene scene = read_scene_content("bar", document.dump());
  return std::make_unique<Simulation>(scene, build_model(scene, {make_box(3 * cells, cells, cells, kBar)}),
                                      &gpu.programs, false);
}

// At these places, which are vertices of the mesh.
Trajectory motion_of(Gpu& gpu, const nlohmann::json& document, int cells, const std::vector<Eigen::Vector3d>& places) {
  const auto run = bar_of(gpu, document, cells);
  std::vector<std::size_t> vertices;
  for (const Eigen::Vector3d& x : places)
    for (std::size_t v = 0; v < run->model.rest_positions.size(); ++v)
      if ((run->model.rest_positions[v] - x).norm() < 1e-9) vertices.push_back(v);
  REQUIRE(vertices.size() == places.size());
  Trajectory motion;
  for (int step = 1; step <= kStepsOfMotion; ++step) {
    run->step();
    if (step % (kStepsOfMotion / 10) != 0) continue;
    const State state = run->state();
    motion.displacement.emplace_back();
    for (const std::size_t v : vertices) motion.displacement.back().push_back(state.displacement[v]);
  }
  return motion;
}

}  // namespace

TEST_CASE("the mesh's estimated error over a run is near the error against a finer mesh") {
  struct Case {
    std::string what, elements;
    int cells, finer;
    double least, most;
  };
  // An impact on finer tets happens at other moments.
  const Case c = GENERATE(
      Case{"falls from level", "linear", 2, 2, 0.7, 1.5}, Case{"falls from level", "quadratic", 1, 4, 0.7, 1.5},
      Case{"thrown sideways", "quadratic", 1, 4, 0.7, 1.5}, Case{"under a hand", "linear", 2, 2, 0.7, 1.5},
      Case{"pressed by a ball", "quadratic", 1, 4, 0.7, 1.5}, Case{"lands on its end", "linear", 2, 2, 0.5, 2});
  nlohmann::json document = scene_of_bar(c.elements), truth = document;
  const auto with = [&](const std::string& key, const nlohmann::json& value) {
    document[nlohmann::json::json_pointer(key)] = value;
  };
  if (c.what == "thrown sideways") {
    with("/gravity", {0, 0, 0});
    with("/bodies/0/initial_velocity", {0, 0.5, 1});
  } else if (c.what == "under a hand") {
    with("/grabs", {{{"select", {{"box", {{0.29, -1, -1}, {1, 1, 1}}}}},
                     {"translate", {0, 0.05, 0}},
                     {"duration", 0.2},
                     {"stiffness", 200}}});
  } else if (c.what == "pressed by a ball") {
    with("/instruments",
         {{{"name", "ball"},
           {"shape", {{"sphere", {{"radius", 0.05}}}}},
           {"path",
            {{{"time", 0}, {"position", {0.27, 0.16, 0.05}}}, {{"time", 0.4}, {"position", {0.27, 0.11, 0.05}}}}}}});
  } else if (c.what == "lands on its end") {
    document["bodies"][0].erase("fixed");
    with("/bodies/0/transform/rotate_deg", {0, 0, 90});
    with("/bodies/0/transform/translate", {0, 0.02, 0});
    with("/ground", {{"height", 0}});
  }
  Gpu gpu;
  const auto run = bar_of(gpu, document, c.cells);
  for (int step = 0; step < kStepsOfMotion; ++step) run->step();
  truth = document;
  truth["bodies"][0]["elements"] = "quadratic";
  const std::vector<Eigen::Vector3d>& places = run->model.rest_positions;
  const double error =
      error_of(motion_of(gpu, document, c.cells, places), motion_of(gpu, truth, c.finer * c.cells, places)).over_run;
  const RunError estimate = estimate_mesh_error_in_motion(*run, &gpu.programs);
  CAPTURE(c.what, c.elements, error, estimate.over_run / error, estimate.relative,
          estimate_mesh_error(run->model, run->state()).displacement);
  CHECK(estimate.complete);
  CHECK(estimate.over_run > c.least * error);
  CHECK(estimate.over_run < c.most * error);
}

// Estimates of the state alone, with forces as they are, are 0.27 to 2.0 times these errors.
TEST_CASE("the mesh's estimated error of an equilibrium has what the mesh does to large turns and hands") {
  const std::string what = GENERATE("turns far", "is held by a hand");
  const std::string elements = GENERATE("linear", "quadratic");
  nlohmann::json document = scene_of_bar(elements);
  const auto with = [&](const std::string& key, const nlohmann::json& value) {
    document[nlohmann::json::json_pointer(key)] = value;
  };
  with("/bodies/0/materials/default/young_modulus", 3e4);
  if (what == "turns far") {
    with("/bodies/0/materials/default/poisson_ratio", 0.499);
    with("/bodies/0/materials/default/model", "squared");
  } else {
    with("/grabs", {{{"at", {0.3, 0.1, 0.05}}, {"radius", 0.04}, {"translate", {0, 0.05, 0.02}}, {"duration", 0.1}}});
  }
  Gpu gpu;
  nlohmann::json finer = document;
  finer["bodies"][0]["elements"] = "quadratic";
  const int cells = elements == "linear" ? 2 : 1;  // the truth is finer than the tets that the estimate makes of them
  const auto coarse = bar_of(gpu, document, cells), fine = bar_of(gpu, finer, elements == "linear" ? 4 : 3);
  Trajectory own, truth;
  for (const auto& [run, motion] : {std::pair(coarse.get(), &own), std::pair(fine.get(), &truth)}) {
    require_equilibrium(*run, run->solve_static());
    motion->displacement.emplace_back();
    for (const Eigen::Vector3d& x : coarse->model.rest_positions)
      for (std::size_t v = 0; v < run->model.rest_positions.size(); ++v)
        if ((run->model.rest_positions[v] - x).norm() < 1e-9)
          motion->displacement.back().push_back(run->state().displacement[v]);
  }
  const double error = error_of(own, truth).relative;
  const RunError estimate = estimate_mesh_error_at_rest(*coarse, &gpu.programs);
  const double of_state = estimate_mesh_error(coarse->model, coarse->state()).displacement;
  CAPTURE(what, elements, error, estimate.relative / error, of_state / error);
  CHECK(estimate.complete);
  CHECK(estimate.relative > 0.7 * error);
  CHECK(estimate.relative < 1.5 * error);
}

TEST_CASE("a body that flies freely has no error of shape or stress, although rounding deforms it") {
  nlohmann::json document = scene_of_bar(GENERATE("linear", "quadratic"));
  document["bodies"][0].erase("fixed");
  document["bodies"][0]["initial_velocity"] = {1, 2, -0.5};
  Gpu gpu;
  const auto run = bar_of(gpu, document, 1);
  for (int step = 0; step < 10; ++step) run->step();
  const State state = run->state();
  const double peak = peak_of(nodal_stress(run->model, state), run->model).p99;
  const MeshError of_state = estimate_mesh_error(run->model, state);
  const RunError over_run = estimate_mesh_error_in_motion(*run, &gpu.programs);
  const RunError of_solver = estimate_solver_error(*run, &gpu.programs);
  const TimeError in_time = estimate_time_error(*run, &gpu.programs);
  CAPTURE(document["bodies"][0]["elements"], peak, stress_of_rounding(run->model, state), of_state.peak,
          over_run.relative, of_solver.relative, in_time.relative);
  CHECK(peak < 0.5 * stress_of_rounding(run->model, state));
  CHECK(of_state.displacement == 0);
  CHECK(of_state.peak_stress == 0);
  CHECK(over_run.relative < 1e-5);
  CHECK(over_run.peak_stress == 0);
  CHECK(of_solver.peak_stress == 0);
  CHECK(in_time.peak_stress == 0);
  TrueError measured;
  CHECK(measured.measure(*run).peak_stress.solver == 0.0);
}

TEST_CASE("a mesh has no error over a run without steps, and none is told of a repetition that was stopped") {
  Gpu gpu;
  const auto still = bar_of(gpu, scene_of_bar("linear"), 1);
  CHECK(estimate_mesh_error_in_motion(*still, &gpu.programs).over_run == 0);
  still->step();
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(estimate_mesh_error_in_motion(*still, &gpu.programs, stop.get_token()).complete);
}
