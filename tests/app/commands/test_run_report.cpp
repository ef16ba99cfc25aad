// What fascia run reports of a run, on stderr and in stats.json.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
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

// Of 1 cm and 1 MPa: in a step of ten iterations the ground presses it with several times its weight.
TEST_CASE("forces of contact in stats.json are those of the static equilibrium, with either solver", "[cli]") {
  const TemporaryFolder folder;
  write_mesh(folder / "cube.msh", make_box(4, 4, 4, {0.01, 0.01, 0.01}));
  write_file(folder / "cube.json",
             R"({"fascia_scene": 1, "bodies": [{"mesh": "cube.msh", "materials": {"default": {"young_modulus": 1e6}}}],
                 "ground": {"height": 0, "friction": 0.5}})");
  for (const bool reference : {true, false}) {
    std::vector<std::string> arguments = {
        "run", (folder / "cube.json").string(), "--static", "--context", "osmesa", "--quiet", "--stats", "-"};
    if (reference) arguments.push_back("--reference");
    const CommandResult result = run_fascia(arguments);
    CAPTURE(reference, result.err);
    REQUIRE(result.exit_code == 0);
    const nlohmann::json force = nlohmann::json::parse(result.out)["contact"]["ground"]["force_N"];
    CHECK(force[1].get<double>() == Approx(0.00981).epsilon(1e-6));
  }
}

TEST_CASE("a run says where surfaces pass through each other at its end", "[cli]") {
  const TemporaryFolder folder;
  write_mesh(folder / "cube.msh", make_box(1, 1, 1, {0.01, 0.01, 0.01}));
  const auto run = [&](double distance) {
    write_file(folder / "two.json", R"({"fascia_scene": 1, "gravity": [0, 0, 0], "contact": {}, "bodies": [
        {"name": "a", "mesh": "cube.msh"}, {"name": "b", "mesh": "cube.msh", "transform": {"translate": [)" +
                                        std::to_string(distance) + R"(, 0.003, 0.002]}}]})");
    return run_fascia({"run", (folder / "two.json").string(), "--steps", "1", "--reference"});
  };
  const CommandResult inside = run(0.007), apart = run(0.02);
  CAPTURE(inside.err, apart.err);
  CHECK(inside.err.find(" pairs of surface triangles pass through each other at the end") != std::string::npos);
  CHECK(apart.err.find("pass through each other") == std::string::npos);
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
