// The second run of --update, by the command check: goldens of a scene that amplifies rounding.
#include "app/headless/nudged_run.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("goldens of a column that buckles permit what rounding does to it, and no more", "[check]") {
  const TemporaryFolder folder;
  write_mesh(folder / "column.msh", make_box(3, 24, 3, {0.04, 0.5, 0.04}));
  const auto write_scene = [&](const char* young_modulus) {
    write_file(
        folder / "column.json",
        R"({"fascia_scene": 1, "bodies": [{"mesh": "column.msh", "fixed": [{"box": [[-1, -0.01, -1], [1, 0.001, 1]]}],
    "materials": {"default": {"damping": 0, "young_modulus": )" +
            std::string(young_modulus) + "}}}]}");
  };
  write_scene("30000");
  write_file(folder / "check.json",
             R"({"fascia_check": 1, "defaults": {"size": [64, 48], "steps": 120, "samples": 1}})");
  const auto check = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"check", folder.path().string(), "--context", "osmesa"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_fascia(arguments);
  };
  const CommandResult update = check({"--update"});
  INFO(update.out << update.err);
  CHECK(contains(update.out, "column.golden.sensitivity.csv: the motion amplifies rounding"));
  write_scene("30000.004");  // the next number in float32 but one
  const CommandResult other = check({});
  INFO(other.out);
  CHECK(other.exit_code == 0);
  CHECK(contains(other.out, "1 scene, 0 failed"));
  std::filesystem::remove(folder / "column.golden.sensitivity.csv");
  const CommandResult strict = check({});
  INFO(strict.out);
  CHECK(strict.exit_code == 1);
  CHECK(contains(strict.out, "column.golden.csv: the state differs"));
}
