#include <catch2/catch.hpp>

#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("refine proposes settings, or says what is within reach", "[refine]") {
  const std::filesystem::path cube = source_dir() / "assets/scenes/cube.json";
  const CommandResult reached = run_fascia(
      {"refine", cube.string(), "--error", "60%", "--frame", "10s", "--steps", "5", "--quiet", "--context", "osmesa"});
  INFO(reached.out << reached.err);
  CHECK(reached.exit_code == 0);
  CHECK(reached.out.find("--set elements=") != std::string::npos);
  CHECK(reached.out.find("assumed") != std::string::npos);
  const CommandResult impossible = run_fascia({"refine", cube.string(), "--error", "1e-9", "--frame", "0.001ms",
                                               "--steps", "5", "--quiet", "--context", "osmesa"});
  CHECK(impossible.exit_code == 1);
  CHECK(impossible.out.find("not within reach") != std::string::npos);
  for (const std::string option : {"--static", "--reference"}) {
    const CommandResult refused = run_fascia({"refine", cube.string(), option});
    CAPTURE(option, refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find(option + ": leaves nothing to choose") != std::string::npos);
  }
  for (const std::string wrong : {"-2%", "0", "2 %", "much"}) {
    const CommandResult refused = run_fascia({"refine", cube.string(), "--error", wrong});
    CAPTURE(wrong, refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find("expected a positive number") != std::string::npos);
  }
}
