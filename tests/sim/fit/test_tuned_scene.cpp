#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/fit/tuned_scene.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

TunedScene tuned(const Scene& scene, const std::vector<std::string>& keys) {
  return TunedScene(scene, build_model(scene), parameters_of(scene, keys));
}

TEST_CASE("a scene at other values is the scene with them", "[fit]") {
  const test::BlockScene block("\"young_modulus\": 20000, \"poisson_ratio\": 0.4",
                               R"("grabs": [{"at": [0.06, 0.04, 0.02], "translate": [0, 0.01, 0]}], )");
  const Scene scene = block.scene();
  const auto [keys, smooth] =
      GENERATE(std::pair(std::vector<std::string>{"materials.default.young_modulus", "materials.soft.density"}, true),
               std::pair(std::vector<std::string>{"prescribed.0.translate.0", "materials.default.young_modulus"}, true),
               std::pair(std::vector<std::string>{"transform.translate.1", "materials.default.young_modulus"}, false));
  const TunedScene scenes = tuned(scene, keys);
  CHECK(scenes.is_smooth(0) == smooth);
  std::vector<std::string> sets;
  std::vector<double> inner;
  for (const Parameter& p : scenes.parameters()) {
    const double value = 1.25 * p.start + (p.start == 0 ? 0.01 : 0);
    inner.push_back(p.inner(value));
    std::ostringstream text;
    text.precision(17);
    text << p.key << '=' << p.value(inner.back());
    sets.push_back(text.str());
  }
  const Model expected = build_model(block.scene(sets));
  const TunedScene::Built built = scenes.at(inner);
  CHECK(built.scene.bodies[0].material == block.scene(sets).bodies[0].material);
  CHECK(built.model.materials == expected.materials);
  CHECK(built.model.tet_material == expected.tet_material);
  CHECK(built.model.rest_positions == expected.rest_positions);
  REQUIRE(built.model.grabs.size() == 1);
  CHECK(built.model.grabs[0].grip == expected.grabs[0].grip);  // whose stiffness follows the tissue
  CHECK(built.model.motions[0].translate == expected.motions[0].translate);
}

TEST_CASE("a parameter that changes nothing to be measured is refused", "[fit]") {
  const test::BlockScene block;
  for (const char* key : {"duration", "display.ambient_occlusion", "solver.iterations"}) {
    CAPTURE(key);
    CHECK_THROWS_WITH(tuned(block.scene(), {key}), Catch::Contains("changes no tissue and no load"));
  }
  CHECK_THROWS_WITH(tuned(block.scene(), {"materials.bone.density"}), Catch::Contains("no region \"bone\""));
}

}  // namespace
}  // namespace fascia
