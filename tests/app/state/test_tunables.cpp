// Undo and redo of user changes, and regions that get a material of their own during the simulation.
// Covers: app/session/session, sim/simulation/scene_edits
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/state/undo_history.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/material/tissue_looks.h"
#include "sim/material/tissues.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Tunables plain() {
  Tunables tunables;
  tunables.materials.push_back({Material{}, {{"core", MaterialOverride{}}}});
  return tunables;
}

double largest_difference(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.displacement.size(); ++v)
    largest = std::max(largest, (a.displacement[v] - b.displacement[v]).norm());
  return largest;
}

}  // namespace

TEST_CASE("changes are described with their values, as displayed") {
  const Tunables before = plain();
  Tunables after = before;
  CHECK(changes(before, after).empty());
  after.solver.iterations = 40;
  after.materials[0].material.young_modulus = 2e4;
  after.materials[0].region_materials[0].second.density = 1500;
  after.gravity.y() = -1.62;
  after.display.wireframe = true;
  after.grab.grip = 5;
  const std::vector<std::string> lines = changes(before, after);
  const auto has = [&](const std::string& line) { return std::count(lines.begin(), lines.end(), line) == 1; };
  CAPTURE(lines);
  CHECK(has("Iterations: 10 to 40"));
  CHECK(has("Young's modulus, default: 100 kPa to 20 kPa"));
  CHECK(has("Young's modulus, core: 100 kPa to 20 kPa"));  // it follows the default
  CHECK(has("Density, core: 1000 kg/m^3 to 1500 kg/m^3"));
  CHECK(has("Gravity y: 0 m/s^2 to -1.62 m/s^2"));
  CHECK(has("Wireframe: false to true"));
  CHECK(has("Grip: 3 to 5"));
  CHECK(lines.size() == 7);

  INFO("a difference that three digits do not show");
  after = before;
  after.materials[0].region_materials[0].second.young_modulus = 100001;
  CHECK(changes(before, after) == std::vector<std::string>{"Young's modulus, core: 100 kPa to 100.001 kPa"});
  INFO("looks, beside a tissue or on their own");
  after = before;
  after.materials[0].material.look = &tissue_looks()[1];
  after.materials[0].region_materials[0].second.color = {1, 0, 0.5};
  CHECK(changes(before, after) == std::vector<std::string>{"Look, default: Flesh to Liver",
                                                           "Look, core: Flesh to Liver",
                                                           "Color, core: that of the look to #ff0080"});
  after = before;
  apply(*find_tissue("liver"), after.materials[0].material);
  CHECK(changes(before, after) ==
        std::vector<std::string>{"Tissue, default: own values to Liver", "Tissue, core: own values to Liver"});
  INFO("painted regions");
  after = before;
  after.regions = {{{"tumour", {{3, 5}, {9, 9}}}}};
  CHECK(changes(before, after) == std::vector<std::string>{"Painted, tumour: 0 to 4 tets"});
  Tunables other = after;
  other.regions = {{{"tumour", {{3, 6}}}}};
  CHECK(changes(after, other) == std::vector<std::string>{"Painted other tets"});
  INFO("a region with a material of its own");
  after = before;
  after.materials[0].region_materials.clear();
  CHECK(changes(after, before) == std::vector<std::string>{"A material of its own, core"});
  CHECK(changes(before, after) == std::vector<std::string>{"The default material, core"});
}

TEST_CASE("changes of a session are undone to the bit, region by region, during the simulation") {
  Graphics graphics = open_graphics(headless(), false);
  const Scene scene = open_scene(source_dir() / "assets/scenes/inclusion.json");
  Session session(graphics, scene, false);
  Simulation& simulation = session.simulation;
  GrabSettings grab;
  const Tunables opened = tunables_of(session, grab);
  for (int i = 0; i < 3; ++i) simulation.step();

  Tunables turned = opened;
  REQUIRE(turned.materials[0].region_materials.size() == 1);
  turned.materials[0].material.young_modulus *= 3;
  turned.materials[0].region_materials.clear();  // the region has the default again
  turned.solver.iterations = 7;
  turned.gravity = {1, -2, 3};
  turned.display.color = ColorBy::strain;
  turned.grab.grip = 9;
  const State before = simulation.state();
  set_tunables(session, grab, turned);
  CHECK(tunables_of(session, grab) == turned);
  CHECK(simulation.model.materials.size() == 1);
  CHECK(simulation.gpu()->color() == ColorBy::strain);
  CHECK(largest_difference(before, simulation.state()) == 0);  // the state stays
  CHECK(simulation.time() == Approx(3 * scene.solver.time_step));
  for (int i = 0; i < 2; ++i) simulation.step();
  CHECK_FALSE(simulation.check_now());

  set_tunables(session, grab, opened);
  CHECK(tunables_of(session, grab) == opened);
  CHECK(simulation.model.materials == build_model(scene).materials);
  CHECK(simulation.model.tet_material == build_model(scene).tet_material);
  simulation.step();
  CHECK_FALSE(simulation.check_now());

  INFO("from the start it is the scene that was opened, to the bit");
  simulation.reset();
  Session fresh(graphics, scene, false);
  for (int i = 0; i < 4; ++i) {
    simulation.step();
    fresh.simulation.step();
  }
  CHECK(largest_difference(simulation.state(), fresh.simulation.state()) == 0);
}

TEST_CASE("an entry that names no region changes nothing") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, open_scene(source_dir() / "assets/scenes/inclusion.json"), false);
  std::vector<MaterialEntries> entries = tunables_of(session, {}).materials;
  entries[0].region_materials.emplace_back("nowhere", MaterialOverride{});
  const Tunables before = tunables_of(session, {});
  CHECK_THROWS_WITH(session.simulation.set_material_entries(entries), Catch::Contains("nowhere"));
  CHECK(tunables_of(session, {}) == before);
}

TEST_CASE("a uniform scene whose regions get equal materials reads no material per tet") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, open_scene(source_dir() / "assets/scenes/inclusion.json"), false);
  CHECK(session.simulation.gpu()->buffers().material_per_tet());
  Tunables tunables = tunables_of(session, {});
  tunables.materials[0].region_materials.clear();
  GrabSettings grab;
  set_tunables(session, grab, tunables);
  CHECK_FALSE(session.simulation.gpu()->buffers().material_per_tet());
}
