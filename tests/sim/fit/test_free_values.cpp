// The values that a fit can find in a scene.
#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/fit/free_values.h"
#include "sim/fit/tuned_scene.h"
#include "sim/grab/build_model.h"
#include "tests/support/support.h"

namespace fascia {
namespace {

TEST_CASE("every material has its free values, under keys that the scene takes", "[fit]") {
  for (const char* name : {"cube", "inclusion"}) {
    const Scene scene = open_scene(test::source_dir() / "assets/scenes" / (std::string(name) + ".json"));
    const Model model = build_model(scene);
    const std::vector<FreeValue> values = free_values(scene, model);
    CAPTURE(name, values.size());
    CHECK(values.size() == 4 * model.materials.size());  // of laws without a value of their own
    for (const FreeValue& value : values) CHECK_NOTHROW(parameters_of(scene, {value.key}));
    CHECK(values[0].key == "materials.default.young_modulus");
    CHECK(values[0].field == "young_modulus");
    CHECK(values[0].material == model.material_names[0]);
    CHECK(values[0].unit == "Pa");
    CHECK(values.back().material == model.material_names.back());
  }
}

}  // namespace
}  // namespace fascia
