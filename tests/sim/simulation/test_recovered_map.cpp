#include "sim/simulation/recovered_map.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/nodal_stress.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Scene cube() { return open_scene(source_dir() / "assets/scenes/cube.json"); }

void step(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

bool wait_for_news(RecoveredMap& map, const Simulation& simulation) {
  for (int wait = 0; wait < 6000; ++wait) {
    if (map.update(simulation, ColorBy::mesh_error)) return true;
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
  RecoveredMap map;
  CHECK(map.values(ColorBy::mesh_error).empty());
  REQUIRE(wait_for_news(map, simulation));
  const std::vector<float> first = map.values(ColorBy::mesh_error);
  const MeshError error = estimate_mesh_error(simulation.model, simulation.state());
  CHECK(first == at_vertices(simulation.model, error));
  CHECK(*std::max_element(first.begin(), first.end()) > 0.1f);
  CHECK_FALSE(wait_for_news(map, simulation));  // the same state
  CHECK_FALSE(map.busy());

  simulation.step();
  REQUIRE(wait_for_news(map, simulation));
  CHECK(map.values(ColorBy::mesh_error) != first);

  // Other materials have other stresses at the same place.
  Material stiffer = simulation.model.materials[0];
  stiffer.poisson_ratio = 0.1;
  simulation.set_material(0, stiffer);
  const std::vector<float> before = map.values(ColorBy::mesh_error);
  REQUIRE(wait_for_news(map, simulation));
  CHECK(map.values(ColorBy::mesh_error) != before);
}

TEST_CASE("a map that is measured at once has the values of the current state, and forgets a pending estimate") {
  Gpu gpu;
  Simulation simulation(cube(), &gpu.programs, false);
  step(simulation, 3);
  RecoveredMap map;
  map.update(simulation, ColorBy::mesh_error);
  map.forget();
  CHECK_FALSE(map.busy());
  simulation.step();
  map.measure(simulation, ColorBy::mesh_error);
  CHECK(map.values(ColorBy::mesh_error) ==
        at_vertices(simulation.model, estimate_mesh_error(simulation.model, simulation.state())));
}

TEST_CASE(
    "the map of the recovered stress is that of the vertices, and the values of another map are not taken for it") {
  Gpu gpu;
  Simulation simulation(cube(), &gpu.programs, false);
  step(simulation, 3);
  RecoveredMap map;
  map.measure(simulation, ColorBy::mesh_error);
  CHECK(map.values(ColorBy::recovered_von_mises).empty());
  CHECK_FALSE(map.peak());
  map.measure(simulation, ColorBy::recovered_von_mises);
  CHECK(map.values(ColorBy::mesh_error).empty());
  const std::vector<double> stress = nodal_stress(simulation.model, simulation.state()).von_mises;
  CHECK(map.values(ColorBy::recovered_von_mises) == std::vector<float>(stress.begin(), stress.end()));
  CHECK(*std::max_element(stress.begin(), stress.end()) > 0);
  REQUIRE(map.peak());
  CHECK(map.peak()->max == *std::max_element(stress.begin(), stress.end()));
  CHECK(map.peak()->p99 == exceeded_by_a_hundredth(stress, vertex_volumes(simulation.model)));

  // Shown in turn, each is computed anew.
  map.update(simulation, ColorBy::mesh_error);
  CHECK(map.busy());
  bool news = false;
  for (int wait = 0; wait < 6000 && !news; ++wait) {
    news = map.update(simulation, ColorBy::recovered_von_mises);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  CHECK(news);
  CHECK(map.values(ColorBy::recovered_von_mises) == std::vector<float>(stress.begin(), stress.end()));
}
