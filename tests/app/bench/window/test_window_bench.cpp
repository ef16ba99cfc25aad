// fascia bench window in its quick form: a real window on a virtual screen. Values depend on the machine; what is
// tested is that they are there and possible.
// Covers: app/bench/window/virtual_screen, app/window/parts/frame_log
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

#include "app/bench/window/virtual_screen.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

TEST_CASE("virtual screens find numbers of their own and leave nothing behind") {
  const auto made = [](const std::string& name) {  // when its socket was; another server may take a number at once
    std::error_code absent;
    const auto time = std::filesystem::last_write_time("/tmp/.X11-unix/X" + name.substr(1), absent);
    return absent ? std::nullopt : std::optional(time);
  };
  std::string first, second;
  std::optional<std::filesystem::file_time_type> made_first, made_second;
  {
    const VirtualScreen one(320, 200), other(320, 200);
    first = one.name();
    second = other.name();
    CAPTURE(first, second);
    CHECK(first != second);
    made_first = made(first);
    made_second = made(second);
    REQUIRE(made_first);
    REQUIRE(made_second);
  }
  CAPTURE(first, second);
  CHECK(made(first) != made_first);
  CHECK(made(second) != made_second);
}

TEST_CASE("a window is measured cold and warm, by its own log of frames") {
  const TemporaryFolder folder;
  const CommandResult result =
      run_command({FASCIA_BINARY, "bench", "window", "--quick", "--out", (folder / "out").string()});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  std::istringstream in(read_file(folder / "out/window.csv"));
  std::vector<std::string> columns;
  std::vector<std::map<std::string, std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    REQUIRE(cells.size() == columns.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (c == 0) rows.emplace_back();
      rows.back()[columns[c]] = cells[c];
    }
  }
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].at("kernels") == "cold");
  CHECK(rows[1].at("kernels") == "warm");
  CHECK(rows[0].at("fused_after_s") != "0");
  CHECK(rows[1].at("fused_after_s") == "0");  // compiled, and known to be
  for (const auto& row : rows) {
    CAPTURE(row);
    const auto number = [&](const char* column) { return std::stod(row.at(column)); };
    CHECK(row.at("program") == "this");
    CHECK(number("first_picture_s") > 0);
    CHECK(number("share_of_real_time") > 0);
    CHECK(number("share_of_real_time") < 1.1);
    CHECK(number("pictures_per_s") > 0);
    CHECK(number("frame_ms") > 0);
    CHECK(number("latency_ms") > 0);
    CHECK(number("steps_per_frame") > 0);
    for (const char* part : {"panels_ms", "steps_ms", "scene_ms", "overlay_ms", "present_ms"}) CHECK(number(part) > 0);
    CHECK(number("panels_ms") + number("steps_ms") + number("scene_ms") < 3 * number("frame_ms"));
  }
}

TEST_CASE("another build is measured only if it knows --frame-log") {
  const TemporaryFolder folder;
  const CommandResult result = run_command(
      {FASCIA_BINARY, "bench", "window", "--quick", "--against", "/bin/true", "--out", (folder / "out").string()});
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.err, Catch::Contains("/bin/true") && Catch::Contains("--frame-log"));
}
