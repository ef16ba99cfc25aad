#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/fit/measured/drive.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using test::BlockScene;

constexpr const char* kMaterial = R"("young_modulus": 20000, "poisson_ratio": 0.4)";

TEST_CASE("the time of a displacement is that of what moves", "[fit]") {
  const BlockScene pulled;
  const Drive motion(build_model(pulled.scene()), "a.csv:1");
  CHECK(motion.farthest() == Approx(0.02));
  CHECK(*motion.time_of(0) == 0);
  CHECK(*motion.time_of(0.005) == Approx(0.25));
  CHECK(*motion.time_of(0.02) == Approx(1));
  CHECK(!motion.time_of(0.021));

  const BlockScene grabbed(
      kMaterial, R"("grabs": [{"at": [0.06, 0.04, 0.02], "translate": [0, 0, 0.01], "start": 1, "duration": 2}], )",
      "");
  CHECK(*Drive(build_model(grabbed.scene()), "a.csv:1").time_of(0.005) == Approx(2));

  const BlockScene pressed(kMaterial,
                           R"("instruments": [{"name": "probe", "shape": {"sphere": {"radius": 0.01}}, "path": [
      {"time": 0, "position": [0.06, 0.08, 0.02]}, {"time": 2, "position": [0.06, 0.06, 0.02]},
      {"time": 3, "position": [0.06, 0.08, 0.02]}]}], )",
                           "");
  CHECK(*Drive(build_model(pressed.scene()), "a.csv:1").time_of(0.015) == Approx(1.5));  // on its way in
}

TEST_CASE("a displacement needs one thing that translates", "[fit]") {
  const BlockScene still(kMaterial, "", "");
  CHECK_THROWS_WITH(Drive(build_model(still.scene()), "a.csv:1"),
                    Catch::StartsWith("a.csv:1: is the displacement of one of 0 moved things"));
  const BlockScene turned(kMaterial, "",
                          R"({"select": {"box": [[0.1199, -1, -1], [1, 1, 1]]}, "rotate_deg": {"axis": [1, 0, 0],
      "angle": 20, "center": [0, 0, 0]}, "start": 0, "duration": 1})");
  CHECK_THROWS_WITH(Drive(build_model(turned.scene()), "a.csv:1"),
                    "a.csv:1: is the displacement of a motion that does not only translate; expected time_s");
}

}  // namespace
}  // namespace fascia
