#include "sim/simulation/errors/solver_error.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sim/accuracy/relative_distance.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/errors/worst_step.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kSteps = 40;

// A bar that falls from level, the half at its end a thousand times softer.
Scene bar_scene(const std::string& elements, const SolverSettings& settings) {
  nlohmann::json scene{{"fascia_scene", 1}};
  nlohmann::json& body = scene["bodies"][0];
  body = {{"mesh", "bar"}, {"elements", elements}};
  for (const auto& [name, modulus] : {std::pair("0", 5e6), std::pair("1", 5e3)})
    body["materials"][name] = {
        {"young_modulus", modulus}, {"poisson_ratio", 0.45}, {"density", 1000}, {"damping", 0.02}};
  body["fixed"] = {{{"box", {{-1, -1, -1}, {0.001, 1, 1}}}}};
  Scene read = read_scene_content("bar", scene.dump());
  read.solver = settings;
  return read;
}

TetMesh bar() {
  TetMesh mesh = make_box(6, 2, 2, {0.24, 0.04, 0.04});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    double x = 0;
    for (const std::uint32_t v : mesh.tets[t]) x += mesh.positions[v].x() / 4;
    mesh.regions[t] = x > 0.12;
  }
  return mesh;
}

std::unique_ptr<Simulation> of_bar(Gpu& gpu, const Scene& scene, bool reference) {
  return std::make_unique<Simulation>(scene, build_model(scene, {bar()}), reference ? nullptr : &gpu.programs,
                                      reference);
}

}  // namespace

TEST_CASE("the estimated error of the solver is 0.7 to 1.5 of the error against the reference solver's motion") {
  struct Case {
    std::string elements;
    Integrator integrator;
    Method method;
    int iterations;
  };
  const Case c = GENERATE(Case{"quadratic", Integrator::implicit_euler, Method::two_level, 3},
                          Case{"quadratic", Integrator::bdf2, Method::two_level, 10},
                          Case{"linear", Integrator::bdf2, Method::two_level, 3},
                          Case{"linear", Integrator::implicit_euler, Method::gauss_seidel, 20});
  SolverSettings settings;
  settings.method = c.method;
  settings.acceleration = info_of(c.method).accelerations.front();
  settings.integrator = c.integrator;
  settings.iterations = c.iterations;
  settings.rest_speed = 0;
  Gpu gpu;
  const Scene scene = bar_scene(c.elements, settings);
  const auto run = of_bar(gpu, scene, false), exact = of_bar(gpu, scene, true);
  WorstStep worst(run->model.tets.size(), kSteps);
  double squares = 0, whole = 0;
  for (int step = 1; step <= kSteps; ++step) {
    run->step();
    exact->step();
    worst.look(*run);
    if (step % (kSteps / 10) != 0) continue;
    const State found = run->state(), truth = exact->state();
    for (std::size_t v = 0; v < truth.displacement.size(); ++v) {
      squares += (found.displacement[v] - truth.displacement[v]).squaredNorm();
      whole += truth.displacement[v].squaredNorm();
    }
  }
  const double error = relative_distance(run->state().displacement, exact->state().displacement),
               over_run = std::sqrt(squares / whole);
  const RunError estimate = estimate_solver_error(*run, &gpu.programs);
  CAPTURE(c.elements, name_of(c.integrator), name_of(c.method), c.iterations, error, estimate.relative / error,
          over_run, estimate.over_run / over_run, worst.of_displacement());
  CHECK(estimate.complete);
  CHECK(estimate.relative > 0.7 * error);
  CHECK(estimate.relative < 1.5 * error);
  CHECK(estimate.over_run > 0.7 * over_run);
  CHECK(estimate.over_run < 1.5 * over_run);
}

TEST_CASE("a run without steps has no error of the solver, and a repetition that is stopped none to tell") {
  Gpu gpu;
  const auto still = of_bar(gpu, bar_scene("linear", SolverSettings()), false);
  CHECK(estimate_solver_error(*still, &gpu.programs).relative == 0);
  still->step();
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(estimate_solver_error(*still, &gpu.programs, stop.get_token()).complete);
}
