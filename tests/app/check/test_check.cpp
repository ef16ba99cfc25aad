// fascia check in a CI system: a folder, exit codes, files of failures, JUnit XML.
// Covers: check_folder, app/commands/check
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "app/check/check_folder.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

std::string shipped(const char* scene) { return (source_dir() / "assets/scenes" / scene).string(); }

// Two cubes that pass once they have goldens, and one missing mesh.
void fill(const fs::path& folder) {
  write_file(folder / "check.json",
             R"({"fascia_check": 1, "defaults": {"size": [64, 48], "steps": 3, "samples": 1}, "scenes": {
    "broken": {"scene": "missing.json"},
    "cube": {"scene": ")" +
                 shipped("cube.json") + R"("},
    "soft <cube> & \"co\"": {"scene": ")" +
                 shipped("cube.json") + R"(", "set": ["materials.default.young_modulus=500"], "picture": false}}})");
}

CommandResult check(const fs::path& folder, std::vector<std::string> more) {
  more.insert(more.begin(), {"check", folder.string(), "--context", "osmesa"});
  return run_fascia(more);
}

void expect_error(const std::string& settings, const std::vector<std::string>& texts) {
  const TemporaryFolder folder;
  write_file(folder / "a.json", "{}");
  write_file(folder / "check.json", settings);
  try {
    read_check_folder(folder.path());
    FAIL("no error from " << settings);
  } catch (const Error& error) {
    for (const std::string& text : texts) {
      CAPTURE(error.what(), text);
      CHECK(contains(error.what(), text));
    }
  }
}

}  // namespace

TEST_CASE("check: one broken scene does not stop the others, and goldens make them pass", "[check]") {
  const TemporaryFolder folder, out;
  fill(folder.path());
  const CommandResult none = check(folder.path(), {"--out", out.path().string()});
  INFO(none.out << none.err);
  CHECK(none.exit_code == 1);
  CHECK(contains(none.out, "missing.json: no such file"));
  CHECK(contains(none.out, "cube.golden.png: no golden yet"));
  CHECK(contains(none.out, "3 scenes, 3 failed"));
  CHECK(fs::exists(out / "cube.new.png"));
  CHECK(fs::exists(out / "cube.new.csv"));

  CHECK(contains(none.err, "no golden yet for 3 of 3 scenes: broken, cube, soft <cube> & \"co\""));
  write_file(folder / "endless.json", R"({"fascia_scene": 1, "duration": 1e6, "bodies": [{"mesh": "missing.msh"}]})");
  const CommandResult early = check(folder.path(), {"--only", "endless"});  // the mesh is not even looked for
  INFO(early.out << early.err);
  CHECK(early.exit_code == 1);
  CHECK(contains(early.err, "no golden yet for 1 of 1 scene: endless"));
  CHECK(contains(early.out, "endless.golden.csv: no golden yet"));
  CHECK_FALSE(contains(early.out, "missing.msh"));
  fs::remove(folder / "endless.json");

  const CommandResult update = check(folder.path(), {"--update", "--only", "cube"});
  INFO(update.out << update.err);
  CHECK(update.exit_code == 0);
  CHECK(contains(update.out, "cube.golden.csv: new"));
  const CommandResult again =
      check(folder.path(), {"--out", out.path().string(), "--junit", (out / "report.xml").string()});
  INFO(again.out << again.err);
  CHECK(again.exit_code == 1);
  CHECK(contains(again.out, "3 scenes, 1 failed"));
  CHECK_FALSE(fs::exists(out / "cube.new.png"));  // of the earlier run

  // Parsed as in a CI system.
  const CommandResult parsed = run_command(
      {"python3", "-c",
       "import sys, xml.etree.ElementTree as E\n"
       "suite = E.parse(sys.argv[1]).getroot().find('testsuite')\n"
       "print(suite.get('tests'), suite.get('failures'), suite.get('errors'))\n"
       "for c in suite:\n"
       "  e = c.find('error')\n"
       "  print(c.get('name'), float(c.get('time')) > 0, e is not None and 'no such file' in e.get('message'))\n",
       (out / "report.xml").string()});
  INFO(parsed.err);
  CHECK(parsed.out == "3 0 1\nbroken True True\ncube True False\nsoft <cube> & \"co\" True False\n");
  CHECK(check(folder.path(), {"--only", "nothing like it"}).exit_code == 1);
}

// A column that buckles, whose motion makes 0.07 of its size of a rounding, and contact with friction.
TEST_CASE("check: goldens made with one load path hold to the bit with the other", "[check]") {
  const TemporaryFolder folder;
  write_mesh(folder / "column.msh", make_box(3, 24, 3, {0.04, 0.5, 0.04}));
  write_file(
      folder / "column.json",
      R"({"fascia_scene": 1, "bodies": [{"mesh": "column.msh", "fixed": [{"box": [[-1, -0.01, -1], [1, 0.001, 1]]}],
    "materials": {"default": {"young_modulus": 30000, "damping": 0}}}]})");
  write_file(folder / "check.json", R"({"fascia_check": 1, "defaults": {"size": [64, 48], "samples": 1, "steps": 60,
    "max_mean": 0, "max_share": 0, "state_tolerance": 0, "contact_tolerance": 0}, "scenes": {
    "column": {"steps": 120}, "pressed": {"scene": ")" +
                                        shipped("palpation.json") + R"("}}})");
  const char* const made_with = GENERATE("ssbo", "texel");
  const std::string checked_with = made_with == std::string("ssbo") ? "texel" : "ssbo";
  CAPTURE(made_with);
  REQUIRE(check(folder.path(), {"--update", "--loads", made_with}).exit_code == 0);
  CHECK(fs::exists(folder / "pressed.golden.contact.csv"));
  const CommandResult result = check(folder.path(), {"--loads", checked_with});
  INFO(result.out << result.err);
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "2 scenes, 0 failed"));
}

TEST_CASE("check: scenes at the same time have the results and the order of one after the other", "[check]") {
  const TemporaryFolder folder, out;
  fill(folder.path());
  REQUIRE(check(folder.path(), {"--update", "--only", "cube", "--jobs", "2"}).exit_code == 0);
  const auto names = [&](const char* jobs) {
    const CommandResult result =
        check(folder.path(), {"--jobs", jobs, "--out", out.path().string(), "--html", (out / "report.html").string(),
                              "--junit", (out / "report.xml").string()});
    CAPTURE(jobs, result.out, result.err);
    CHECK(result.exit_code == 1);
    CHECK(contains(result.out, "3 scenes, 1 failed"));
    std::vector<std::pair<std::size_t, std::string>> order;
    for (const char* name : {"soft <cube>", "cube ", "broken "}) {
      order.emplace_back(result.out.find(std::string("\n") + name), name);
      REQUIRE(order.back().first != std::string::npos);
    }
    std::sort(order.begin(), order.end());
    std::string rows;
    for (const auto& row : order) rows += row.second;
    return rows;
  };
  CHECK(names("1") == "broken cube soft <cube>");
  CHECK(names("3") == "broken cube soft <cube>");
  const std::string xml = read_file(out / "report.xml"), html = read_file(out / "report.html");
  CAPTURE(xml, html.substr(0, 3000));
  CHECK(contains(xml, "<property name=\"mean_measured\" value=\"0\"/>"));
  CHECK(contains(xml, "<property name=\"state_allowed\" value=\"1e-05\"/>"));
  CHECK(contains(html, "3 scenes, 1 failed"));
  CHECK(contains(html, "data:image/png;base64,"));
  CHECK(xml.find("broken") < xml.find("\"cube\""));
}

TEST_CASE("check: a changed scene fails and writes its picture and the difference", "[check]") {
  const TemporaryFolder folder, out;
  write_file(folder / "check.json",
             R"({"fascia_check": 1, "defaults": {"size": [64, 48], "steps": 3}, "scenes": {"cube": {"scene": ")" +
                 shipped("cube.json") + R"("}}})");
  REQUIRE(check(folder.path(), {"--update"}).exit_code == 0);
  write_file(folder / "check.json",
             R"({"fascia_check": 1, "defaults": {"size": [64, 48], "steps": 3}, "scenes": {"cube": {"scene": ")" +
                 shipped("cube.json") + R"(", "set": ["materials.default.young_modulus=500"]}}})");
  const CommandResult failed =
      check(folder.path(), {"--out", out.path().string(), "--junit", (out / "report.xml").string()});
  INFO(failed.out << failed.err);
  CHECK(failed.exit_code == 1);
  CHECK(contains(failed.out, "young_modulus: golden 5000, now 500"));
  for (const char* left : {"cube.new.png", "cube.new.csv", "cube.diff.png"}) CHECK(fs::exists(out / left));
  CHECK(contains(read_file(out / "report.xml"), "<failure message="));
  CHECK(contains(read_file(out / "report.xml"), "llvmpipe"));
}

TEST_CASE("an interrupted check --update does not change goldens", "[check]") {
  const TemporaryFolder folder;
  const auto settings = [&](const char* steps) {
    write_file(folder / "check.json",
               R"({"fascia_check": 1, "scenes": {"cube": {"scene": ")" + shipped("cube.json") +
                   R"("}}, "defaults": {"size": [64, 48], "set": ["solver.rest_speed=0"], "steps": )" + steps + "}}");
  };
  settings("2");
  REQUIRE(check(folder.path(), {"--update"}).exit_code == 0);
  const std::string picture = read_file(folder / "cube.golden.png"), state = read_file(folder / "cube.golden.csv");
  settings("1000000");  // hours
  const CommandResult cut = run_command({"timeout", "--preserve-status", "-s", "INT", "4", FASCIA_BINARY, "check",
                                         folder.path().string(), "--context", "osmesa", "--update"});
  INFO(cut.out << cut.err);
  CHECK(cut.exit_code == 130);
  CHECK((read_file(folder / "cube.golden.png") == picture));
  CHECK((read_file(folder / "cube.golden.csv") == state));
}

TEST_CASE("check: a golden may come from run --export, with its provenance beside it", "[check]") {
  const TemporaryFolder folder;
  fs::copy_file(source_dir() / "assets/meshes/cube.msh", folder / "cube.msh");
  write_file(folder / "cube.json",
             R"({"fascia_scene": 1, "bodies": [{"mesh": "cube.msh", "fixed": [{"lowest": 0.02}]}]})");
  write_file(folder / "check.json",
             R"({"fascia_check": 1, "defaults": {"size": [64, 48], "steps": 3, "picture": false}})");
  REQUIRE(run_fascia({"run", (folder / "cube.json").string(), "--context", "osmesa", "--quiet", "--steps", "3",
                      "--export", (folder / "cube.golden.csv").string()})
              .exit_code == 0);
  REQUIRE(fs::exists(folder / "cube.golden.csv.json"));
  const CommandResult result = check(folder.path(), {});
  INFO(result.out << result.err);
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "1 scene, 0 failed"));
}

TEST_CASE("check.json is strict", "[check]") {
  expect_error(R"({"fascia_check": 1, "default": {}})",
               {"check.json", "unknown key \"default\"", "perhaps \"defaults\""});
  expect_error(R"({"fascia_check": 2})", {"fascia_check", "expected"});
  expect_error(R"({"fascia_check": 1, "defaults": {"size": [8, 240]}})", {"defaults.size[0]", "16 to 16384"});
  expect_error(R"({"fascia_check": 1, "defaults": {"max_mean": "1/0"}})", {"defaults.max_mean", "0.5/255"});
  expect_error(R"({"fascia_check": 1, "defaults": {"steps": 1, "time": 1}})", {"defaults.time", "one of them"});
  expect_error(R"({"fascia_check": 1, "defaults": {"picture": false, "state": false}})", {"defaults", "neither"});
  expect_error(R"({"fascia_check": 1, "scenes": {"b": {}}})", {"scenes.b", "no b.json"});
  expect_error(R"({"fascia_check": 1, "scenes": {"a": {"scene": "x.json"}}})",
               {"scenes.a.scene", "a.json has the same goldens"});
  expect_error(R"({"fascia_check": 1, "scenes": {"../b": {"scene": "x.json"}}})", {"file name"});
}

TEST_CASE("check settings: those of a scene override the defaults", "[check]") {
  const TemporaryFolder folder;
  write_file(folder / "a.json", "{}");
  write_file(folder / "b.fascia", "{}");
  write_file(folder / "check.json", R"({"fascia_check": 1, "defaults": {"steps": 5, "max_mean": "1/255"},
                                        "scenes": {"a": {"time": 2, "state_tolerance": 0.5, "picture": false}}})");
  const std::vector<CheckCase> cases = read_check_folder(folder.path());
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].name == "a");
  CHECK_FALSE(cases[0].options.steps);
  CHECK(cases[0].options.time == 2.0);
  CHECK(cases[0].options.limits.state == 0.5);
  CHECK(cases[0].options.limits.mean == 1.0 / 255);
  CHECK(cases[0].options.compare.empty());
  CHECK(cases[1].options.steps == 5);
  CHECK(cases[1].options.input == (folder / "b.fascia").string());
  CHECK(cases[1].options.compare == (folder / "b.golden.png").string());
  const TemporaryFolder empty;
  CHECK_THROWS_AS(read_check_folder(empty.path()), Error);
}
