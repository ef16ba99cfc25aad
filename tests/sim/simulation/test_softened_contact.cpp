// Tissue that tools press stays where it is when its material becomes softer, by both solvers.
// Covers: simulation
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/newton.h"
#include "sim/simulation/simulation.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a slider that makes pressed tissue softer does not throw it off", "[contact]") {
  constexpr double kSize = 0.05;  // [m]
  const bool by_reference = GENERATE(false, true), own_entry = GENERATE(false, true);
  const TemporaryFolder folder;
  TetMesh mesh = make_box(3, 3, 3, {kSize, kSize, kSize});
  mesh.regions.assign(mesh.tets.size(), 1);
  write_mesh(folder / "cube.msh", mesh);
  Scene scene;
  scene.file = folder / "cube.json";
  scene.gravity.setZero();
  Body body;
  body.name = "cube";
  body.mesh = (folder / "cube.msh").string();
  body.material.young_modulus = 1e6;
  body.material.damping = 0.05;
  scene.bodies.push_back(body);
  scene.tools.ground = Ground{0, 0.5};
  Instrument ball{"ball", ToolShape(SphereShape{{0, 0, 0}, 0.02}), std::nullopt, {}, false};
  ball.path = {{0, {0.025, 0.071, 0.025}, {0, 0, 0}, 0}, {0.3, {0.027, 0.064, 0.025}, {0, 0, 0}, 0}};
  scene.tools.instruments.push_back(ball);

  const Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(scene, by_reference ? nullptr : graphics.programs.get(), by_reference);
  for (int i = 0; i < 24; ++i) simulation.step();
  Material softer = simulation.model.materials[0];
  softer.young_modulus *= 1e-3;
  if (own_entry) {
    std::vector<MaterialEntries> entries = material_entries(simulation.scene, simulation.model, {softer});
    MaterialOverride same;
    same.young_modulus = softer.young_modulus;
    entries[0].region_materials.emplace_back("1", same);
    simulation.set_material_entries(entries);
  } else {
    simulation.set_material(0, softer);
  }
  const double elastic = reference::measure(simulation.model, simulation.state()).elastic;
  simulation.step();
  const double kinetic = reference::measure(simulation.model, simulation.state()).kinetic;
  CAPTURE(by_reference, own_entry, kinetic, elastic);
  CHECK(elastic > 0);
  CHECK(kinetic < 0.01 * elastic);
}
