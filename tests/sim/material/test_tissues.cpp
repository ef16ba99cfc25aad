// Presets of tissues: the table, and the effect of "preset" in a scene and on the command line.
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "sim/material/tissue_looks.h"
#include "sim/material/tissues.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("every tissue has values that a scene permits, a range around them and a source with its year") {
  std::set<std::string> names;
  CHECK(tissues().size() >= 16);
  for (const Tissue& tissue : tissues()) {
    CAPTURE(tissue.name);
    CHECK(names.insert(tissue.name).second);
    CHECK(find_tissue(tissue.name) == &tissue);
    Material material;
    apply(tissue, material);
    visit_material(material, [&](double value, const char* name, const char*, double min, double max, auto&&...) {
      CAPTURE(name, value);
      CHECK(value >= min);
      CHECK(value <= max);
    });
    CHECK(tissue.least < tissue.young_modulus);
    CHECK(tissue.young_modulus < tissue.most);
    CHECK(tissue.poisson_ratio <= 0.45);  // above it linear tets lock
    CHECK(tissue.density > 900);
    CHECK(tissue.density < 2000);
    CHECK(std::regex_search(tissue.source, std::regex(R"((19[5-9]|20[0-2])\d, )")));
    CHECK(std::string(tissue.conditions).size() > 20);
    CHECK(about(tissue).find(tissue.source) != std::string::npos);
    REQUIRE(tissue_of(material));
    CHECK(tissue_of(material)->young_modulus == tissue.young_modulus);
    REQUIRE(material.look);
    CHECK(material.look->name == std::string(tissue.look));
  }
  CHECK(find_tissue("Liver") == nullptr);
  CHECK(tissue_of(Material{}) == nullptr);
}

TEST_CASE("the printed table has a line of values, conditions and a source for every tissue") {
  std::ostringstream out;
  print_tissues(out);
  for (const Tissue& tissue : tissues()) {
    CAPTURE(tissue.name);
    CHECK(out.str().find(std::string("\n") + tissue.name + " ") != std::string::npos);
    CHECK(out.str().find(tissue.source) != std::string::npos);
  }
}

TEST_CASE("a preset sets the values that its entry does not give") {
  const Tissue& liver = *find_tissue("liver");
  const Body body =
      SceneFile(scene_with_materials(R"({"default": {"young_modulus": 1234, "preset": "liver", "damping": 0.5},
                                            "2": {"preset": "liver"}, "3": {"density": 900, "preset": "liver"}})"))
          .open()
          .bodies[0];
  CHECK(body.material == Material{1234, liver.poisson_ratio, liver.density, 0.5, Material().model,
                                  Material().mooney_ratio, find_look("liver")});
  CHECK(body.region_materials[0].second ==
        MaterialOverride{liver.young_modulus, liver.poisson_ratio, liver.density, {}, {}, {}, find_look("liver")});
  CHECK(body.region_materials[1].second ==
        MaterialOverride{liver.young_modulus, liver.poisson_ratio, 900, {}, {}, {}, find_look("liver")});
}

TEST_CASE("a preset of the command line replaces the file's numbers, not those of the command line") {
  const SceneFile file(
      scene_with_materials(R"({"default": {"young_modulus": 1e6, "density": 2000, "damping": 0.25}})"));
  const Tissue& fat = *find_tissue("fat");
  CHECK(file.open({"materials.default.preset=fat"}).bodies[0].material ==
        Material{fat.young_modulus, fat.poisson_ratio, fat.density, 0.25, Material().model, Material().mooney_ratio,
                 find_look("fat")});
  for (const std::vector<std::string>& sets :
       {std::vector<std::string>{"materials.default.density=930", "materials.default.preset=fat"},
        std::vector<std::string>{"materials.default.preset=fat", "bodies[0].materials.default.density=930"}})
    CHECK(file.open(sets).bodies[0].material == Material{fat.young_modulus, fat.poisson_ratio, 930, 0.25,
                                                         Material().model, Material().mooney_ratio, find_look("fat")});
  CHECK(file.open({"materials.7.preset=fat"}).bodies[0].region_materials[0].second ==
        MaterialOverride{fat.young_modulus, fat.poisson_ratio, fat.density, {}, {}, {}, find_look("fat")});
}

TEST_CASE("a preset that does not exist gives the nearest name and the list") {
  const std::string error = SceneFile(scene_with_materials(R"({"default": {"preset": "livr"}})")).open_error();
  CHECK(error.find("s.json: bodies[0].materials.default.preset: is \"livr\", perhaps \"liver\"; expected a tissue that "
                   "fascia info --tissues lists: ") == 0);
  for (const std::string& name : tissue_names()) CHECK(error.find(name) != std::string::npos);
  CHECK(SceneFile(scene_text())
            .open_error({"materials.default.preset=fatt"})
            .find("--set materials.default.preset: is \"fatt\", perhaps \"fat\"") == 0);
  CHECK(SceneFile(scene_with_materials(R"({"default": {"preset": 3}})"))
            .open_error()
            .find("preset: is 3; expected a tissue") != std::string::npos);
}

TEST_CASE("the shipped liver is made of a tissue of the table") {
  for (const char* name : {"liver", "liver_hands"}) {
    const Scene scene = open_scene(source_dir() / "assets/scenes" / (std::string(name) + ".json"));
    const Tissue* tissue = tissue_of(scene.bodies.at(0).material);
    REQUIRE(tissue);
    CHECK(tissue->name == std::string("liver_indented"));
    CHECK(scene.bodies[0].material.damping == 0.01);
  }
}
