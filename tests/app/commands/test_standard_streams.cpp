// "-" on the command line: a scene from standard input, one result to standard output, and a plain refusal for other
// options.
// Covers: app/session/open_input
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

const fs::path& scenes() {
  static const fs::path path = source_dir() / "assets/scenes";
  return path;
}

// Runs fascia with this text on its standard input.
CommandResult fed(const std::string& text, const Words& arguments, const fs::path& folder) {
  const TemporaryFolder input;
  write_file(input / "text", text);
  Words all{"/bin/sh",    "-c", "text=$1; shift; cat \"$text\" | exec \"$@\"", "sh", (input / "text").string(),
            FASCIA_BINARY};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_command(all, folder);
}

Words run(const std::string& scene, const Words& more) {
  Words all{"run", scene, "--quiet", "--context", "osmesa", "--steps", "3"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

TEST_CASE("a scene on standard input is the same scene, with paths relative to the working folder", "[streams]") {
  const std::string text = read_file(scenes() / "cube.json");
  const CommandResult file = run_fascia(run("cube.json", {"--hash"}), scenes());
  const CommandResult input = fed(text, run("-", {"--hash"}), scenes());
  CAPTURE(file.out, input.out, input.err);
  CHECK(file.exit_code == 0);
  CHECK(input.exit_code == 0);
  CHECK_THAT(input.out, StartsWith("state "));
  CHECK(input.out == file.out);
  const CommandResult changed = fed(text, run("-", {"--hash", "--set", "gravity.1=-1"}), scenes());
  CAPTURE(changed.out);
  CHECK(changed.exit_code == 0);
  CHECK(changed.out != file.out);
}

TEST_CASE("render and info accept a scene on standard input", "[streams]") {
  const TemporaryFolder folder;
  const std::string text = read_file(scenes() / "cube.json");
  const std::string picture = (folder / "shot.png").string();
  // Two sides: the scene is opened twice.
  const CommandResult render = fed(text,
                                   {"render", "-", "--quiet", "--context", "osmesa", "--steps", "1", "--size", "64x48",
                                    "--out", picture, "--split", "solver.iterations=2"},
                                   scenes());
  CAPTURE(render.err);
  CHECK(render.exit_code == 0);
  CHECK(fs::exists(picture));
  const CommandResult info = fed(text, {"info", "-"}, scenes()), same = run_fascia({"info", "cube.json"}, scenes());
  CAPTURE(info.out, info.err);
  CHECK(info.exit_code == 0);
  CHECK_THAT(info.out, Contains("coloring"));
  CHECK(info.out == same.out);
}

TEST_CASE("errors in standard input name standard input", "[streams]") {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& text) {
    const CommandResult result = fed(text, run("-", {}), folder.path());
    CAPTURE(text, result.out, result.err);
    CHECK(result.exit_code == 1);
    CHECK(result.out.empty());
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    return result.err;
  };
  CHECK_THAT(said(""), StartsWith("standard input: is empty; expected a scene"));
  CHECK_THAT(said("{\n  \"fascia_scene\": 1,\n  \"bodies\": [,]\n}\n"), StartsWith("standard input:3:"));
  CHECK_THAT(said(R"({"fascia_scene": 1, "bodies": [{"mesh": "no.msh"}], "gravty": 1})"),
             StartsWith("standard input: gravty: unknown key"));
  CHECK_THAT(said(R"({"fascia_scene": 1, "bodies": [{"mesh": "no.msh"}]})"), Contains("no.msh"));
}

TEST_CASE("standard output receives only one result", "[streams]") {
  const TemporaryFolder folder;
  const std::string cube = (scenes() / "cube.json").string();
  const auto out_of = [&](const std::string& option) {
    Words arguments{"run",     cube, "--context", "osmesa",
                    "--steps", "3",  option,      "-"};  // not quiet: messages go to stderr
    const CommandResult result = run_fascia(arguments, folder.path());
    CAPTURE(option, result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("3 steps"));
    return result.out;
  };
  CHECK(nlohmann::json::parse(out_of("--stats")).at("steps") == 3);

  const std::string history = out_of("--history");
  CAPTURE(history);
  CHECK_THAT(history, StartsWith("# "));
  const std::string rows = history.substr(history.rfind("\n#") + 1);
  CHECK(std::count(rows.begin(), rows.end(), '\n') ==
        1 + 1 + 4);  // the last note, the names, the start and three steps

  const std::string state = out_of("--export");
  CHECK(fs::is_empty(folder.path()));
  REQUIRE(run_fascia(run(cube, {"--export", (folder / "state.csv").string()})).exit_code == 0);
  CHECK_THAT(state, StartsWith("index,x,y,z\n"));
  CHECK(state == read_file(folder / "state.csv"));
}

TEST_CASE("input and output may both be streams", "[streams]") {
  const CommandResult result = fed(read_file(scenes() / "cube.json"), run("-", {"--stats", "-"}), scenes());
  CAPTURE(result.out, result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(nlohmann::json::parse(result.out).at("tets").get<int>() > 0);
}

TEST_CASE("- is refused in one line by options that do not support it", "[streams]") {
  const TemporaryFolder folder;
  const std::string cube = (scenes() / "cube.json").string(), mesh = (source_dir() / "assets/meshes/cube.msh").string();
  const std::vector<Words> cases{{"-"},
                                 {"view", "-"},
                                 {"render", cube, "--out", "-"},
                                 {"render", cube, "--video", "-"},
                                 {"render", cube, "--compare", "-"},
                                 {"render", cube, "--compare", "g.png", "--diff", "-"},
                                 {"render", cube, "--state", "-"},
                                 {"run", "--replay", "-"},
                                 {"run", cube, "--data-dir", "-"},
                                 {"check", "-"},
                                 {"check", ".", "--junit", "-"},
                                 {"check", ".", "--out", "-"},
                                 {"convert", mesh, "-"},
                                 {"convert", "-", "x.msh"},
                                 {"bench", "speed", "--out", "-"},
                                 {"bench", "speed", "--out", "x", "--against", "-"},
                                 {"stress", "--out", "-"},
                                 {"soak", "-", "--out", "x"},
                                 {"run", cube, "--stats", "-", "--history", "-"},
                                 {"run", cube, "--stats", "-", "--export", "-"},
                                 {"run", cube, "--stats", "-", "--hash"},
                                 {"run", cube, "--export", "-", "--every", "2"}};
  for (const Words& arguments : cases) {
    const CommandResult result = run_fascia(arguments, folder.path());
    CAPTURE(arguments, result.out, result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    CHECK_THAT(result.err, Contains("-") && Contains("expected "));
  }
  CHECK(fs::is_empty(folder.path()));
  // With a folder, the name is a file.
  CHECK(run_fascia(run(cube, {"--stats", "./-"}), folder.path()).exit_code == 0);
  CHECK(fs::exists(folder / "-"));
}
