// Looks of tissues: the table, and the keys look and color in a scene, on the command line and in saved scenes.
#include "sim/material/tissue_looks.h"

#include <set>

#include "sim/model/region_materials.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("every look has a name of its own, colors of a display and amounts in their ranges") {
  std::set<std::string> names;
  for (const TissueLook& look : tissue_looks()) {
    CAPTURE(look.name);
    CHECK(names.insert(look.name).second);
    CHECK(find_look(look.name) == &look);
    for (const SrgbColor& color : {look.color, look.patches, look.lines})
      for (const float part : color) CHECK((part >= 0.05f && part <= 0.97f));
    for (const float share : {look.patchiness, look.line_share, look.wetness, look.scattering})
      CHECK((share >= 0 && share <= 1));
    CHECK((look.patch_size >= 0.05f && look.patch_size <= 0.5f));
    CHECK((look.stretch >= 1 && look.stretch <= 8));
    CHECK((look.bumpiness >= 0 && look.bumpiness <= 0.5f));
  }
  CHECK(names.size() >= 12);
  CHECK(look_names().size() == names.size());
  CHECK(find_look("Liver") == nullptr);
}

TEST_CASE("a material has the look and color of its entry, else of its preset, else of the default") {
  const Body body = SceneFile(scene_with_materials(R"({"default": {"preset": "liver"}, "2": {"color": [1, 0.5, 0]},
                                            "3": {"preset": "fat", "look": "bone"}, "4": {"preset": "fat"}})"))
                        .open()
                        .bodies[0];
  CHECK(body.material.look == find_look("liver"));
  CHECK_FALSE(body.material.color);
  const auto region = [&](std::size_t i) { return with_override(body.material, body.region_materials[i].second); };
  CHECK(region(0).look == find_look("liver"));
  CHECK(region(0).color == std::array{1.0, 0.5, 0.0});
  CHECK(region(1).look == find_look("bone"));
  CHECK(region(2).look == find_look("fat"));
  CHECK(SceneFile(scene_text()).open().bodies[0].material.look == nullptr);
}

TEST_CASE("look and color can be overridden, and a preset of the command line replaces the file's look") {
  const SceneFile file(scene_with_materials(R"({"default": {"look": "skin", "color": [0.5, 0.25, 0.125]}})"));
  const auto material = [&](const std::vector<std::string>& sets) { return file.open(sets).bodies[0].material; };
  CHECK(material({"materials.default.look=bone"}).look == find_look("bone"));
  CHECK(material({"materials.default.color=[0, 1, 0.5]"}).color == std::array{0.0, 1.0, 0.5});
  CHECK(material({"materials.default.color.1=0.75"}).color == std::array{0.5, 0.75, 0.125});
  CHECK(material({"materials.default.preset=fat"}).look == find_look("fat"));
  CHECK(material({"materials.default.look=bone", "materials.default.preset=fat"}).look == find_look("bone"));
}

TEST_CASE("a saved scene keeps look and color") {
  const SceneFile file(
      scene_with_materials(R"({"default": {"look": "skin"}, "2": {"look": "fat", "color": [0.1, 0.2, 0.3]}})"));
  const Scene scene = file.open();
  const Scene again = read_scene_content(file.path(), scene_to_json(scene, file.path().parent_path()));
  CHECK(again.bodies[0].material == scene.bodies[0].material);
  CHECK(again.bodies[0].region_materials == scene.bodies[0].region_materials);
}

TEST_CASE("a look that does not exist and a color beyond the display's are one line each") {
  const auto error = [](const std::string& entry, const std::vector<std::string>& sets = {}) {
    return SceneFile(scene_with_materials("{\"default\": {" + entry + "}}")).open_error(sets);
  };
  const std::string look = error(R"("look": "livr")");
  CHECK(look.find("s.json: bodies[0].materials.default.look: is \"livr\", perhaps \"liver\"; expected a look that "
                  "exists: flesh, liver, kidney") == 0);
  CHECK(look.find('\n') == std::string::npos);
  CHECK(error(R"("look": 3)").find("s.json: bodies[0].materials.default.look: is 3; expected a look that exists") == 0);
  CHECK(error(R"("color": [0.5, 1.5, 0])") == "s.json: bodies[0].materials.default.color[1]: is 1.5; expected 0 to 1");
  CHECK(error(R"("color": "red")").find("s.json: bodies[0].materials.default.color: is \"red\"; expected") == 0);
  CHECK(error("", {"materials.default.look=fatt"}).find("--set materials.default.look: is \"fatt\", perhaps \"fat\"") ==
        0);
}
