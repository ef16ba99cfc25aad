// Tets that are painted into regions in an open scene.
#include "app/state/painted_regions.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "app/state/brush_settings.h"
#include "app/state/continued_session.h"
#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/model/region_materials.h"
#include "sim/output/state_export.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

using Indices = std::vector<std::uint32_t>;

Scene with(Scene scene, const Painting& painting) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    scene.bodies[b].regions = painting.regions[b];
    scene.bodies[b].material = painting.materials[b].material;
    scene.bodies[b].region_materials = painting.materials[b].region_materials;
  }
  return scene;
}

std::size_t count_of(const Model& model, const std::string& material) {
  const auto index = std::find(model.material_names.begin(), model.material_names.end(), material);
  return static_cast<std::size_t>(std::count(model.tet_material.begin(), model.tet_material.end(),
                                             static_cast<std::uint32_t>(index - model.material_names.begin())));
}

MaterialOverride stiff() {
  MaterialOverride values;
  values.young_modulus = 1e6;
  return values;
}

}  // namespace

TEST_CASE("painted tets are a region with a material, more of them join it, and the last erased one takes both away") {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  const Model before = build_model(scene);
  CHECK(with_painted(scene, before, {}, "tumour", stiff()) == painting_of(scene, before));

  const Painting first = with_painted(scene, before, Indices{3, 4, 5, 9}, "tumour", stiff());
  CHECK(first.regions == RegionSets{{{"tumour", {{3, 5}, {9, 9}}}}});
  REQUIRE(first.materials[0].region_materials.size() == 1);
  CHECK(first.materials[0].region_materials[0] == std::pair<std::string, MaterialOverride>("tumour", stiff()));
  scene = with(scene, first);
  const Model painted = build_model(scene);
  CHECK(count_of(painted, "cube: tumour") == 4);

  const Painting more = with_painted(scene, painted, Indices{6, 7}, "tumour", MaterialOverride());
  CHECK(more.regions == RegionSets{{{"tumour", {{3, 7}, {9, 9}}}}});
  CHECK(more.materials == first.materials);
  const Painting second = with_painted(scene, painted, Indices{4, 9}, "cyst", MaterialOverride());
  CHECK(second.regions == RegionSets{{{"tumour", {{3, 3}, {5, 5}}}, {"cyst", {{4, 4}, {9, 9}}}}});
  CHECK(second.materials[0].region_materials.size() == 2);
  CHECK(second.materials[0].region_materials[0].first == "cyst");  // by name
  CHECK(count_of(build_model(with(scene, second)), "cube: cyst") == 2);

  const Painting erased = with_painted(scene, painted, Indices{3, 4, 5, 9, 20}, "", MaterialOverride());
  CHECK(erased.regions == RegionSets{{}});
  CHECK(erased.materials[0].region_materials.empty());
  INFO("a region whose tets are all painted over goes as well");
  const Painting over = with_painted(scene, painted, Indices{3, 4, 5, 9}, "cyst", MaterialOverride());
  REQUIRE(over.materials[0].region_materials.size() == 1);
  CHECK(over.materials[0].region_materials[0].first == "cyst");
}

TEST_CASE("regions of the mesh file are painted under their names, and keep their materials") {
  const Scene scene = open_scene(source_dir() / "assets/scenes/inclusion.json");
  const Model model = build_model(scene);
  REQUIRE(model.bodies[0].regions.size() >= 2);
  const auto key_of_tet = [&](std::uint32_t t) {
    return key_of_region(model.bodies[0].regions, model.file_mesh.regions[model.tet_source[t]]);
  };
  const std::string key = key_of_tet(0);
  std::uint32_t other = 0;
  while (key_of_tet(other) == key) ++other;
  INFO("a tet that has the region already needs no entry");
  CHECK(with_painted(scene, model, Indices{0}, key, stiff()) == painting_of(scene, model));
  const Painting painting = with_painted(scene, model, Indices{0, other}, key, stiff());
  CHECK(painting.regions == RegionSets{{{key, {{model.tet_source[other], model.tet_source[other]}}}}});
  CHECK(painting.materials == painting_of(scene, model).materials);
  const Scene changed = with(scene, painting);
  const Model painted = build_model(changed);
  CHECK(painted.tet_material[other] == painted.tet_material[0]);
  CHECK(with_painted(changed, painted, Indices{other}, "", stiff()) == painting_of(scene, model));
}

TEST_CASE("the tets of each body are counted from its own first one") {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].transform.translate.x() = 1;
  const Model model = build_model(scene);
  const std::uint32_t begin = model.bodies[1].tet_begin;
  const Painting painting = with_painted(scene, model, Indices{1, begin, begin + 2}, "tumour", stiff());
  CHECK(painting.regions == RegionSets{{{"tumour", {{1, 1}}}}, {{"tumour", {{0, 0}, {2, 2}}}}});
  const Model painted = build_model(with(scene, painting));
  CHECK(painted.file_mesh.regions[painted.tet_source[begin + 2]] == painted.file_mesh.regions[painted.tet_source[1]]);
}

TEST_CASE("a painted session continues from the state, and its regions survive saving and exporting") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false);
  for (int i = 0; i < 5; ++i) session.simulation.step();
  const State before = session.simulation.state();
  const Indices tets{1, 2, 3, 30};
  const Scene scene = with(session.simulation.scene, with_painted(session.simulation.scene, session.simulation.model,
                                                                  tets, "tumour", BrushSettings().fresh_material()));
  const auto painted = continued_session(graphics, session, scene);
  const State after = painted->simulation.state();
  CHECK(after.time == before.time);
  for (std::size_t v = 0; v < before.displacement.size(); ++v)
    REQUIRE((after.displacement[v] - before.displacement[v]).norm() < 1e-6);
  const Model& model = painted->simulation.model;
  CHECK(model.materials.at(model.tet_material[30]).young_modulus == BrushSettings().tissue->young_modulus);

  const TemporaryFolder folder;
  write_file(folder / "saved.json", scene_to_json(painted->simulation.scene, folder.path()));
  const Scene read = open_scene(folder / "saved.json");
  CHECK(read.bodies[0].regions == scene.bodies[0].regions);
  CHECK(read.bodies[0].region_materials == scene.bodies[0].region_materials);
  CHECK(build_model(read).tet_material == model.tet_material);
  for (const char* name : {"state.vtu", "state.msh"}) {
    CAPTURE(name);
    write_state(folder / name, model.file_mesh, reference::export_fields(model, after), Provenance());
    const TetMesh exported = read_mesh(folder / name).mesh;
    CHECK(exported.regions == model.file_mesh.regions);
    const int number = exported.regions[model.tet_source[30]];
    CHECK(exported.region_names.at(number) == "tumour");
    CHECK(std::count(exported.regions.begin(), exported.regions.end(), number) == 4);
  }
}
