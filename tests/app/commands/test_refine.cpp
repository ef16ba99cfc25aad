#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

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
  CHECK(impossible.out.find("for the error: no choice; the least error found is ") != std::string::npos);
  CHECK(impossible.out.find("for the time: no choice; the fastest takes ") != std::string::npos);
  for (const std::string option : {"--static", "--reference"}) {
    const CommandResult refused = run_fascia({"refine", cube.string(), option});
    CAPTURE(option, refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find(option + ": leaves nothing to choose") != std::string::npos);
  }
  for (const std::string wrong : {"-2%", "0", "2 %", "much", "2", "100%"}) {
    const CommandResult refused = run_fascia({"refine", cube.string(), "--error", wrong});
    CAPTURE(wrong, refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find("expected a positive number") != std::string::npos);
  }
}

TEST_CASE("refine runs what it proposes, and its options make that of every body", "[refine]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "box.obj") << "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\n"
                                       "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
  // A block that a capsule is pressed into, and one that hangs beside it.
  const std::string material =
      R"("materials": {"default": {"young_modulus": 2e4, "poisson_ratio": 0.4, "damping": 0.02}})";
  std::ofstream(folder / "blocks.json") << R"({"fascia_scene": 1, "bodies": [
        {"name": "pressed", "mesh": "box.obj", "resolution": 3, "transform": {"scale": 0.1}, )"
                                        << material << R"(, "fixed": [{"box": [[-1, -1, -1], [1, 0.001, 1]]}]},
        {"name": "hanging", "mesh": "box.obj", "resolution": 2, "transform": {"scale": 0.1, "translate": [0.3, 0, 0]}, )"
                                        << material << R"(, "fixed": [{"box": [[-1, 0.099, -1], [1, 1, 1]]}]}],
        "instruments": [{"name": "probe", "shape": {"capsule": {"from": [-0.1, 0, 0], "to": [0.2, 0, 0], "radius": 0.03}},
          "path": [{"time": 0, "position": [0, 0.135, 0.05]}, {"time": 0.1, "position": [0, 0.115, 0.05]}]}]})";
  const std::string scene = (folder / "blocks.json").string();
  const CommandResult proposed =
      run_fascia({"refine", scene, "--error", "25%", "--frame", "1s", "--steps", "6", "--context", "osmesa"});
  INFO(proposed.out << proposed.err);
  REQUIRE(proposed.exit_code == 0);
  CHECK(proposed.out.find("extrapolated") == std::string::npos);
  CHECK(proposed.out.find("with the choice proposed") != std::string::npos);
  // The numbers are those of one of the runs.
  std::istringstream out(proposed.out);
  std::size_t tets = 0;
  std::string line;
  std::getline(out, line);
  out >> tets;
  CHECK(proposed.err.find("fascia: " + std::to_string(tets) + ' ') != std::string::npos);
  // Run as the options say, the scene has that many tets.
  std::vector<std::string> run{
      "run", scene, "--steps", "1", "--quiet", "--context", "osmesa", "--stats", (folder / "stats.json").string()};
  std::istringstream words(proposed.out.substr(proposed.out.find("--set")));
  std::size_t options = 0;
  for (std::string word; words >> word && word == "--set"; ++options) {
    words >> word;
    run.insert(run.end(), {"--set", word});
  }
  CHECK(options == 7);  // elements and resolution of two bodies, integrator, substeps, iterations
  const CommandResult result = run_fascia(run);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  std::ifstream stats(folder / "stats.json");
  const std::string written{std::istreambuf_iterator<char>(stats), {}};
  INFO(written);
  CHECK(written.find("\"tets\": " + std::to_string(tets)) != std::string::npos);
}
