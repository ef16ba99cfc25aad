// The shipped scenes against assets/check, on both software contexts, by fascia check itself; and that differences
// fail. Goldens are made by scripts/update_goldens.sh. Tolerances: docs/guide/regression.md.
// Covers: contact_golden, difference_picture, provenance_difference
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "app/golden/difference_picture.h"
#include "app/golden/golden.h"
#include "app/golden/provenance_difference.h"
#include "base/error.h"
#include "base/file.h"
#include "render/target/image.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

const fs::path& cube() {
  static const fs::path path = source_dir() / "assets/scenes/cube.json";
  return path;
}

// Renders a picture and a state of the cube, small and with few steps.
CommandResult render(std::vector<std::string> more) {
  std::vector<std::string> arguments{"render", cube().string(), "--context", "osmesa", "--size",
                                     "64x48",  "--quiet",       "--steps",   "3"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_fascia(arguments);
}

Image plain(std::uint8_t value) { return {16, 16, std::vector<std::uint8_t>(16 * 16 * 4, value)}; }

}  // namespace

TEST_CASE("shipped scenes look and move as before", "[golden]") {
  const std::string context = GENERATE("osmesa", "egl");
  const CommandResult result =
      run_fascia({"check", (source_dir() / "assets/check").string(), "--context", context, "--out", "golden_failures"});
  INFO(result.out << result.err);
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, " 0 failed"));
}

TEST_CASE("render compares with goldens, and makes them", "[golden]") {
  const TemporaryFolder folder;
  const std::string png = folder / "golden.png", csv = folder / "golden.csv";
  const std::vector<std::string> goldens{"--compare", png, "--state", csv};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), goldens.begin(), goldens.end());
    return render(more);
  };

  const CommandResult missing = with({});
  CHECK(missing.exit_code == 1);
  CHECK(contains(missing.err, "golden.png: no golden yet; expected one: --update makes it"));
  CHECK(contains(missing.err, "golden.csv: no golden yet"));
  CHECK(fs::is_empty(folder.path()));
  REQUIRE(with({"--update"}).exit_code == 0);
  CHECK(read_png_metadata(png).size() >= 6);
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
  const CommandResult same = with({});
  INFO(same.err);
  CHECK(same.exit_code == 0);
  CHECK(same.err.empty());

  // An unchanged golden is not written.
  const fs::file_time_type written = fs::last_write_time(png);
  CHECK(with({"--update"}).exit_code == 0);
  CHECK(fs::last_write_time(png) == written);

  const CommandResult other =
      with({"--set", "materials.default.young_modulus=500", "--diff", (folder / "diff.png").string()});
  INFO(other.err);
  CHECK(other.exit_code == 1);
  CHECK(contains(other.err, "golden.csv: the state differs, largest deviation "));
  CHECK(contains(other.err, "(at most 1e-05) of the scene's size"));
  CHECK(contains(other.err, "materials.default.young_modulus: golden 5000, now 500"));
  CHECK(read_png(folder / "diff.png").width == 3 * 64 + 8);

  // Wide tolerances permit the difference.
  CHECK(with({"--set", "materials.default.young_modulus=500", "--max-mean", "255/255", "--max-share", "1",
              "--state-tolerance", "1"})
            .exit_code == 0);
}

TEST_CASE("goldens that cannot be compared each give one line", "[golden]") {
  const TemporaryFolder folder;
  const std::string png = folder / "golden.png", csv = folder / "golden.csv";
  write_file(png, "no picture");
  write_file(csv, "index,x,y,z\n0,0,0,0\n1,0,0,0\n");
  const CommandResult unreadable = render({"--compare", png, "--state", csv});
  INFO(unreadable.err);
  CHECK(unreadable.exit_code == 1);
  CHECK(contains(unreadable.err, "golden.png: no PNG signature"));
  CHECK(contains(unreadable.err, "golden.csv: has 2 vertices up to 1; expected 0 to 176"));
  CHECK(std::count(unreadable.err.begin(), unreadable.err.end(), '\n') == 2);

  write_png(png, plain(7));
  const CommandResult size = render({"--compare", png});
  CHECK(contains(size.err, "is a picture of 16x16; expected the new picture's 64x48"));
  CHECK(contains(size.err, "carries no provenance"));
  CHECK(render({"--compare", png, "--max-mean", "half"}).exit_code == 2);
  CHECK(render({"--max-mean", "0.1", "--out", png}).exit_code == 2);
  CHECK(render({"--update", "--out", png}).exit_code == 2);
  const std::string diff = folder / "diff.png";
  write_file(diff, "of an earlier run");
  CHECK(render({"--compare", png, "--diff", diff}).exit_code == 1);  // of another size
  CHECK_FALSE(fs::exists(diff));
}

TEST_CASE("a comparison counts the values beyond its limits", "[golden]") {
  const TemporaryFolder folder;
  Outcome outcome;
  outcome.picture = plain(100);
  outcome.mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  outcome.fields.displacement = {{0, 0, 0}, {0.5, 0, 0}};
  outcome.size = 10;
  const GoldenFiles goldens{folder / "a.png", folder / "a.csv"};
  update_goldens(outcome, goldens);
  CHECK(compare(outcome, goldens, {0, 0, 0}).passed());

  outcome.picture.rgba[5] = 151;  // one channel of one pixel of 256, by 51 of 255
  outcome.fields.displacement[1].x() += 0.01;
  const Comparison c = compare(outcome, goldens, {});
  REQUIRE(c.mean);
  CHECK(*c.mean == Approx(51.0 / 255 / 1024));
  CHECK(*c.share == Approx(1.0 / 256));
  CHECK(*c.deviation == Approx(0.001));
  CHECK(contains(c.findings.at(1).text, "at vertex 1"));
  CHECK(compare(outcome, goldens, {1.0 / 1024, 1.0 / 256, 0.0011}).passed());
  CHECK_FALSE(compare(outcome, goldens, {1.0 / 1024, 1.0 / 257, 0.0011}).passed());
  CHECK_FALSE(compare(outcome, goldens, {0.1 / 1024, 1.0 / 256, 0.0011}).passed());
  CHECK_FALSE(compare(outcome, goldens, {1.0 / 1024, 1.0 / 256, 0.0009}).passed());
}

TEST_CASE("forces of tools are compared where the golden has them", "[golden]") {
  const TemporaryFolder folder;
  Outcome outcome;
  outcome.mesh.positions = {{0, 0, 0}};
  outcome.fields.displacement = {{0, 0, 0}};
  const GoldenFiles goldens{"", folder / "a.golden.csv"};
  update_goldens(outcome, goldens);
  outcome.contact = {{"ground", {0, 10, 0}}, {"a, b", {0.5, 0, -1.0 / 3}}};
  CHECK(compare(outcome, goldens, {}).passed());  // a golden without forces
  CHECK(update_goldens(outcome, goldens).at(1) == (folder / "a.golden.contact.csv").string() + ": new");
  CHECK(update_goldens(outcome, goldens).at(1) == (folder / "a.golden.contact.csv").string() + ": unchanged");
  outcome.contact[1].second.x() += 0.009;
  CHECK(*compare(outcome, goldens, {}).contact == Approx(0.0009));
  CHECK(compare(outcome, goldens, {}).passed());
  outcome.contact[1].second.x() += 0.002;
  CHECK_FALSE(compare(outcome, goldens, {}).passed());
  CHECK(contains(compare(outcome, goldens, {}).findings.at(1).text, "the forces differ, largest difference 0.0011"));
  outcome.contact[0].first = "table";
  CHECK_FALSE(compare(outcome, goldens, {}).passed());
  CHECK(contains(compare(outcome, goldens, {}).findings.at(1).text,
                 "a.golden.contact.csv: the tools differ: golden ground, a, b; now table, a, b"));
  write_file(folder / "a.golden.contact.csv", "force_x_N,force_y_N,force_z_N,tool\n1,2,3\n");
  CHECK(contains(compare(outcome, goldens, {}).findings.at(1).text, "a.golden.contact.csv:2: is no row of a tool"));
}

TEST_CASE("a state with NaN is a different state", "[golden]") {
  const TemporaryFolder folder;
  Outcome outcome;
  outcome.mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  outcome.fields.displacement = {{0, 0, 0}, {0, 0, 0}};
  const GoldenFiles goldens{"", folder / "a.csv"};
  update_goldens(outcome, goldens);
  outcome.fields.displacement[0].x() = std::nan("");
  outcome.fields.displacement[1].x() = 1e-9;
  CHECK_FALSE(compare(outcome, goldens, {}).passed());
}

TEST_CASE("the picture of a difference shows its place and amount", "[golden]") {
  const Image golden = plain(100);
  Image now = golden;
  const auto at = [](const Image& image, int x, int y) {
    return &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
  };
  now.rgba[4 * (8 * 16 + 8)] = 103;  // within the bound
  now.rgba[4 * (5 * 16 + 4)] = 255;  // beyond
  const Image sheet = difference_picture(golden, now, kPixelBound);
  const int third = 2 * (16 + 4);
  CHECK(sheet.width == 3 * 16 + 8);
  CHECK(at(sheet, third + 8, 8)[2] > 150);  // blue
  CHECK(at(sheet, third + 8, 8)[0] < 100);
  CHECK(at(sheet, third + 4, 5)[0] == 255);  // red to yellow
  CHECK(at(sheet, third + 4, 5)[2] == 0);
  for (const int left : {0, 20, 40}) {  // the frame, in all three
    CHECK(at(sheet, left + 4, 3)[0] == 255);
    CHECK(at(sheet, left + 4, 3)[1] == 0);
    CHECK(at(sheet, left + 4, 3)[2] == 255);
  }
}

TEST_CASE("the provenance of two pictures is compared by parameter", "[golden]") {
  const Provenance golden{
      {"Renderer", "A"}, {"Parameters", R"({"solver": {"iterations": 10}, "title": "x"})"}, {"Command line", "a"}};
  Provenance now{{"Renderer", "B"},
                 {"Parameters", R"({"solver": {"iterations": 20, "window": 5}, "title": "x"})"},
                 {"Command line", "b"}};
  CHECK(provenance_differences(golden, now) == std::vector<std::string>{"Renderer: golden A, now B",
                                                                        "solver.iterations: golden 10, now 20",
                                                                        "solver.window: golden none, now 5"});
  CHECK(provenance_differences(now, now).empty());
  CHECK(contains(provenance_differences({}, now).at(0), "no provenance"));
}
