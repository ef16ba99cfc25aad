#include "tests/api/api_scenes.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

TEST_CASE("Settings are read back as they were set, and bad ones change nothing") {
  Simulation simulation(scene_of(standing_cube()), context());
  CHECK(simulation.settings() == Settings());
  Settings settings;
  settings.method = "vertex_descent";
  settings.acceleration = "anderson";
  settings.iterations = 7;
  settings.time_step = 0.01;
  settings.substeps = 2;
  simulation.set_settings(settings);
  CHECK(simulation.settings() == settings);
  simulation.step(3);
  CHECK(simulation.time() == Approx(0.03));
  Settings bad = settings;
  bad.iterations = 0;
  CHECK_THAT(error_of([&] { simulation.set_settings(bad); }),
             Contains("settings.iterations: is 0; expected 1 to 10000"));
  bad = settings;
  bad.acceleration = "subspace";
  CHECK_THAT(error_of([&] { simulation.set_settings(bad); }), Contains("vertex_descent") && Contains("subspace"));
  CHECK(simulation.settings() == settings);
}

TEST_CASE("Every listed solver choice steps, and those with fast convergence reach the state of the reference solver") {
  Scene scene = scene_of(standing_cube());
  scene.settings.iterations = 200;
  Simulation exact(scene, Context::none(), {.reference = true});
  exact.step(5);
  const std::vector<double> expected = exact.positions();
  Context one = context();
  for (const auto& [method, acceleration] : solver_pairs()) {
    CAPTURE(method, acceleration);
    scene.settings.method = method;
    scene.settings.acceleration = acceleration;
    Simulation simulation(scene, one);
    simulation.step(5);
    const std::vector<double> x = simulation.positions();
    double farthest = 0, moved = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      farthest = std::max(farthest, std::abs(x[i] - expected[i]));
      moved = std::max(moved, std::abs(expected[i] - simulation.rest_positions()[i]));
    }
    CHECK(moved > 1e-4);
    CHECK_FALSE(simulation.diverged_vertex());
    if (method == "two_level" || method == "vertex_descent" || method == "exact_xpbd") CHECK(farthest < 0.02 * moved);
  }
}
