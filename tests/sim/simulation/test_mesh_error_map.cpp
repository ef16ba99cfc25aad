#include "sim/simulation/mesh_error_map.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "sim/accuracy/mesh_error.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Scene cube() { return open_scene(source_dir() / "assets/scenes/cube.json"); }

void step(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

bool wait_for_news(MeshErrorMap& map, const Simulation& simulation) {
  for (int wait = 0; wait < 6000; ++wait) {
    if (map.update(simulation)) return true;
    if (!map.busy()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace

TEST_CASE("the map of the mesh's error follows the state, and rests while nothing changes") {
  Gpu gpu;
  Simulation simulation(cube(), &gpu.programs, false);
  step(simulation, 10);
  MeshErrorMap map;
  CHECK(map.values().empty());
  REQUIRE(wait_for_news(map, simulation));
  const std::vector<float> first = map.values();
  const MeshError error = estimate_mesh_error(simulation.model, simulation.state());
  CHECK(first == at_vertices(simulation.model, error));
  CHECK(*std::max_element(first.begin(), first.end()) > 0.1f);
  CHECK_FALSE(wait_for_news(map, simulation));  // the same state
  CHECK_FALSE(map.busy());

  simulation.step();
  REQUIRE(wait_for_news(map, simulation));
  CHECK(map.values() != first);

  // Other materials have other stresses at the same place.
  Material stiffer = simulation.model.materials[0];
  stiffer.poisson_ratio = 0.1;
  simulation.set_material(0, stiffer);
  const std::vector<float> before = map.values();
  REQUIRE(wait_for_news(map, simulation));
  CHECK(map.values() != before);
}

TEST_CASE("a map that is measured at once has the values of the current state, and forgets a pending estimate") {
  Gpu gpu;
  Simulation simulation(cube(), &gpu.programs, false);
  step(simulation, 3);
  MeshErrorMap map;
  map.update(simulation);
  map.forget();
  CHECK_FALSE(map.busy());
  simulation.step();
  map.measure(simulation);
  CHECK(map.values() == at_vertices(simulation.model, estimate_mesh_error(simulation.model, simulation.state())));
}
