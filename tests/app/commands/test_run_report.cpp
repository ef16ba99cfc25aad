// What fascia run reports of a run, on stderr and in stats.json.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a static solve reports its time and no steps", "[cli]") {
  const CommandResult result =
      run_fascia({"run", (source_dir() / "assets/scenes/cube.json").string(), "--static", "--context", "osmesa"});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.err.find("fascia: solved in ") != std::string::npos);
  CHECK(result.err.find("step") == std::string::npos);
}

TEST_CASE("the guide has a row for every key of stats.json", "[cli]") {
  const std::string guide = read_file(source_dir() / "docs/guide/command-line.md");
  const std::string liver = (source_dir() / "assets/scenes/liver_hands.json").string();
  for (const std::string more : {"--error", "--reference"}) {
    const CommandResult result =
        run_fascia({"run", liver, "--steps", "2", "--context", "osmesa", "--quiet", "--stats", "-", more});
    REQUIRE(result.exit_code == 0);
    const nlohmann::json stats = nlohmann::json::parse(result.out);
    for (const auto& item : stats.items()) {
      CAPTURE(more, item.key());
      CHECK((guide.find("`" + item.key() + "`") != std::string::npos ||
             guide.find("`" + item.key() + ".") != std::string::npos));
    }
  }
}
