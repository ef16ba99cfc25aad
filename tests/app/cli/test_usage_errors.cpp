// Wrong command lines: one line that names the wrong word and the likely intention, before any work begins.
// Covers: shared_options
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/check/check_folder.h"
#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

// The error message of a wrong command line, which is one line without usage text.
std::string said(const Words& arguments, const fs::path& folder = ".") {
  const CommandResult result = run_fascia(arguments, folder);
  CAPTURE(arguments, result.err, result.out);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK(result.err.ends_with('\n'));
  CHECK_THAT(result.err, Contains("; ") && !Contains("Usage:") && !Contains("Options:"));
  return result.err;
}

}  // namespace

TEST_CASE("an option before a command, which would be ignored, is refused", "[usage]") {
  CHECK_THAT(said({"--data-dir", "no", "run", "no.json"}),
             Contains("--data-dir: stands before the command run") && Contains("expected it after the command"));
  CHECK_THAT(said({"--quiet", "info", "no.json"}), Contains("--quiet: stands before the command info"));
  CHECK_THAT(said({"liver.json", "--set", "gravity=[0,0,0]", "check", "no"}), Contains("before the command check"));
}

TEST_CASE("an unsupported extension for an option is refused before anything is opened", "[usage]") {
  const TemporaryFolder folder;
  // The scene does not exist: a command that opens it first would report that instead.
  const struct {
    Words arguments;
    std::string option, expected;
  } cases[] = {{{"run", "no.json", "--export", "a.jpg"}, "--export a.jpg", ".vtu, .csv, .msh, .obj or .inp"},
               {{"run", "no.json", "--export", "a"}, "--export a", ".vtu, .csv, .msh, .obj or .inp"},
               {{"run", "no.json", "--history", "a.png"}, "--history a.png", "expected .csv"},
               {{"run", "no.json", "--stats", "a.MP4"}, "--stats a.MP4", "expected .json"},
               {{"run", "no.json", "--stats", "a.csv"}, "--stats a.csv", "expected .json"},
               {{"run", "no.json", "--export", "ok.csv", "--stats", "a.vtu"}, "--stats a.vtu", "expected .json"},
               {{"render", "no.json", "--out", "a.jpg"}, "--out a.jpg", "expected .png"},
               {{"render", "no.json", "--compare", "g.png", "--diff", "a.jpg"}, "--diff a.jpg", "expected .png"},
               {{"render", "no.json", "--video", "a.jpg"}, "--video a.jpg", ".mp4, .webm, .gif"},
               {{"render", "no.json", "--video", "a.video"}, "--video a.video", ".mp4, .webm, .gif"},
               {{"render", "no.json", "--video", "a"}, "--video a", ".mp4, .webm, .gif"},
               {{"render", "no.json", "--video", "a.png"}, "--video a.png", "frames/%05d.png"},
               {{"render", "no.json", "--video", "%05d.jpg"}, "--video %05d.jpg", "frames/%05d.png"},
               {{"render", "no.json", "--state", "a.vtu", "--update"}, "--state a.vtu", "expected .csv"},
               {{"render", "no.json", "--compare", "a.mp4", "--update"}, "--compare a.mp4", "expected .png"},
               {{"view", "no.json", "--export", "a.jpg"}, "--export a.jpg", ".vtu, .csv, .msh, .obj or .inp"},
               {{"view", "no.json", "--stats", "a.png"}, "--stats a.png", "expected .json"},
               {{"check", "no", "--junit", "a.png"}, "--junit a.png", "expected .xml"},
               {{"convert", "no.msh", "a.jpg"}, "OUT a.jpg", ".msh, .vtk, .vtu, .node, .ele, .mesh or .inp"}};
  for (const auto& [arguments, option, expected] : cases)
    CHECK_THAT(said(arguments, folder.path()), Contains(option + ": ") && Contains(expected) && !Contains("no.json"));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("statistics and histories may have any extension except that of another kind of file", "[usage]") {
  const TemporaryFolder folder;
  using Takes = OutputFile::Takes;
  for (const char* name : {"stats.json", "stats.JSON", "stats", "stats.txt", "stats.log", "run.7", "stats.json.old"}) {
    CAPTURE(name);
    CHECK_NOTHROW(require_outputs({{"--stats", (folder / name).string(), {".json"}, Takes::all_but_foreign}}));
  }
  for (const char* name : {"stats.png", "stats.csv", "stats.webm", "stats.vtk", "stats.xml"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(require_outputs({{"--stats", (folder / name).string(), {".json"}, Takes::all_but_foreign}}),
                    UsageError);
  }
  const CommandResult result = run_fascia({"run", cube_path(), "--steps", "1", "--quiet", "--context", "osmesa",
                                           "--stats", "stats", "--history", "rows.txt"},
                                          folder.path());
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(fs::exists(folder / "stats"));
  CHECK(fs::exists(folder / "rows.txt"));
}

TEST_CASE("an unknown command is reported, not the word after it", "[usage]") {
  CHECK_THAT(said({"simulate", "x.json"}),
             Contains("simulate: unknown command, perhaps you meant run") && !Contains("x.json"));
  CHECK_THAT(said({"simulate", cube_path(), "--steps", "3", "--history", "h.csv"}),
             Contains("simulate: unknown command, perhaps you meant run"));
  CHECK_THAT(said({"simulate"}), Contains("simulate: unknown command, perhaps you meant run"));
  CHECK_THAT(said({"frobnicate", "x.json"}),
             Contains("frobnicate: unknown command; expected one of ") && Contains("render") && !Contains("x.json:"));
  CHECK_THAT(said({"rendr", "x.json", "--out", "x.png"}), Contains("rendr: unknown command, perhaps you meant render"));
  CHECK_THAT(said({"help"}), Contains("perhaps you meant --help"));
  CHECK_THAT(said({"bench", "Sped", "--out", "x"}), Contains("Sped: unknown command, perhaps you meant speed"));
  CHECK_THAT(said({"bench", "zzz", "--out", "x"}), Contains("zzz: unknown command; expected one of figures, accuracy, "
                                                            "speed, static, dispatch, skip, contact, window, fill"));
  CHECK_THAT(said({"bench"}), Contains("fascia bench: no command named; expected one of figures"));
  CHECK_THAT(said({cube_path(), "y.json"}), Contains("y.json: not expected here"));  // the first one is a file
  CHECK_THAT(said({"x.json", "y.json"}), Contains("y.json: not expected here"));
  CHECK_THAT(said({"run", "x.json", "y.json", "--zzzz", "5"}), Contains("y.json: not expected here"));
}

TEST_CASE("a usage error is one line without the usage text", "[usage]") {
  for (const Words& arguments : std::vector<Words>{{"run", "--zzzz", "5", "--yyyy", "6"},
                                                   {"run", "--steps"},
                                                   {"run", "--steps", "-1"},
                                                   {"run", "--steps", "5", "--time", "1"},
                                                   {"render", "--fps", "0"},
                                                   {"render", "--size", "12by7", "--out", "x.png"},
                                                   {"render", cube_path()},
                                                   {"run", "--history-every", "2"},
                                                   {"view", "--samples", "two"},
                                                   {"info"},
                                                   {"info", "--tissues", "x.json"},
                                                   {"convert", "one.msh"},
                                                   {"completion"},
                                                   {"stress"},
                                                   {"soak", "--out", "x", "--steps", "1"},
                                                   {"run", "two\nlines.json", "three\nlines.json"},
                                                   {"run", "--color\n", "x"},
                                                   {"run", "--static", "--every", "2"},
                                                   {"run", "--set", "iterations"}})
    CHECK(!said(arguments).empty());
}

TEST_CASE("every mistyped choice and key is suggested, regardless of case and separators", "[usage]") {
  const auto said_of = [](const Words& arguments) {
    Words all{"render", cube_path(), "--steps", "0", "--context", "osmesa", "--out", "never.png"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return said(all);
  };
  CHECK_THAT(said_of({"--color", "vonmises"}),
             Contains("--color: is \"vonmises\", perhaps \"von_mises\"; expected one of none, "));
  CHECK_THAT(said_of({"--color", "Von Mises"}), Contains("perhaps \"von_mises\""));
  CHECK_THAT(said_of({"--color", "VOLUME-RATIO"}), Contains("perhaps \"volume_ratio\""));
  CHECK_THAT(said_of({"--loads", "SSBO"}), Contains("perhaps \"ssbo\""));
  CHECK_THAT(said({"run", cube_path(), "--context", "OSMesa"}), Contains("perhaps \"osmesa\""));
  CHECK_THAT(said({"stress", "--out", "never", "--model", "StableNeoHookean"}),
             Contains("perhaps \"stable_neo_hookean\""));
  CHECK_THAT(said({"completion", "Fish"}), Contains("perhaps \"fish\""));
  CHECK_THAT(said_of({"--camera", "Follow"}), Contains("perhaps \"follow\""));
  CHECK_THAT(said_of({"--Wire-Frame"}), Contains("perhaps you meant --wireframe"));
  CHECK_THAT(said_of({"--data_dir=x"}), Contains("perhaps you meant --data-dir"));
  CHECK_THAT(said_of({"--set", "display.color=vonmises"}),
             Contains("--set display.color: is \"vonmises\", perhaps \"von_mises\""));
  CHECK_THAT(said_of({"--set", "display.wireframe=True"}), Contains("perhaps true; expected true or false"));
  CHECK_THAT(said_of({"--set", "solver.method=Two Level"}), Contains("perhaps \"two_level\""));
  CHECK_THAT(said_of({"--set", "solver.acceleration=nonlinearCG"}), Contains("perhaps \"nonlinear_cg\""));
  CHECK_THAT(said_of({"--set", "materials.default.YoungModulus=1e5"}), Contains("perhaps \"young_modulus\""));
  CHECK_THAT(said_of({"--set", "Solver.iterations=3"}), Contains("unknown key \"Solver\", perhaps \"solver\""));
  CHECK_THAT(said_of({"--set", "material.default.density=900"}),
             Contains("unknown key \"material\", perhaps \"materials\""));
  CHECK_THAT(said_of({"--set", "iterations=3"}), Contains("unknown key \"iterations\", perhaps \"solver.iterations\""));
  CHECK_THAT(said_of({"--grab", "At=0,0,0;translate=0,0.1,0"}), Contains("perhaps \"at\""));
}

TEST_CASE("a grab of the command line that is off the tissue names its option, not the scene", "[usage]") {
  const auto said_of = [](const std::string& grab) {
    const CommandResult result = run_fascia({"run", cube_path(), "--quiet", "--steps", "0", "--grab", grab});
    CHECK(result.exit_code == 1);  // a matter of the scene's tissue, not of the option's form
    return result.err;
  };
  CHECK_THAT(said_of("at=9,9,9;translate=0,0.1,0"),
             Contains("--grab: grabs[0].at: ") && Contains("m from the nearest vertex; expected a place on or near"));
  CHECK_THAT(said_of("at=0,0,0;body=liver;translate=0,0.1,0"),
             Contains("--grab: grabs[0].body: there is no body \"liver\""));
}

TEST_CASE("charts have the endings that are asked for", "[usage]") {
  const TemporaryFolder folder;
  const auto said_of = [&](const std::string& endings) {
    return said({"bench", "figures", "--quick", "--out", (folder / "never").string(), "--charts", endings});
  };
  CHECK_THAT(said_of("svg,jpg"), Contains("--charts: is svg,jpg; expected one or more of svg, png, pdf"));
  CHECK_THAT(said_of("PDF"), Contains("perhaps \"pdf\""));
  CHECK_THAT(said_of(","), Contains("--charts"));
}

TEST_CASE("samples per pixel have one range, for the window, for pictures and for checks", "[usage]") {
  for (const char* command : {"view", "render"}) {
    CHECK_THAT(said({command, "--samples", "257"}), Contains("--samples") && Contains("1 to 256"));
    CHECK_THAT(said({command, "--samples", "0"}), Contains("1 to 256"));
    CHECK_THAT(run_fascia({command, "--help"}).out, Contains("--samples INT in [1 - 256]"));
  }
  const TemporaryFolder folder;
  fs::copy(source_dir() / "assets/scenes/cube.json", folder / "cube.json");
  const auto samples = [&](const std::string& number) {
    write_file(folder / "check.json", R"({"fascia_check": 1, "defaults": {"samples": )" + number + "}}");
    return read_check_folder(folder.path()).at(0).options.samples;
  };
  CHECK(samples("256") == 256);
  CHECK_THROWS_WITH(samples("257"), Contains("1 to 256"));
}
