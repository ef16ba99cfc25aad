// Comparison of times with those of an earlier run.
#include <catch2/catch.hpp>

#include "app/bench/speed_table.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string error_of(const std::filesystem::path& path) {
  try {
    read_speeds(path);
  } catch (const Error& e) {
    const std::string text = e.what();
    return text.substr(text.find("speed.csv"));
  }
  return "";
}

}  // namespace

TEST_CASE("a time is slower if it differs by a tenth and exceeds the spread of both") {
  const std::vector<SpeedRow> then{
      {"a", {10, 9, 11}}, {"b", {10, 9, 11}}, {"c", {10, 9, 15}}, {"d", {10, 9, 11}}, {"gone", {1, 1, 1}}};
  const std::vector<SpeedRow> now{
      {"new", {1, 1, 1}}, {"d", {5, 4, 6}}, {"a", {10.9, 10.8, 12}}, {"b", {12, 11.5, 13}}, {"c", {12, 11.5, 13}}};
  const std::vector<SpeedChange> changes = compare_speeds(then, now);
  REQUIRE(changes.size() == 4);
  CHECK(changes[0].name == "d");
  CHECK(changes[0].ratio == Approx(0.5));
  CHECK_FALSE(changes[0].slower);
  CHECK(changes[1].name == "a");
  CHECK_FALSE(changes[1].slower);  // less than a tenth
  CHECK(changes[2].name == "b");
  CHECK(changes[2].ratio == Approx(1.2));
  CHECK(changes[2].slower);
  CHECK(changes[3].name == "c");
  CHECK_FALSE(changes[3].slower);  // such times occurred before
}

TEST_CASE("times are read from the table that the benchmark writes, and from nothing else") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "speed.csv";
  const auto write = [&](const std::string& text) { write_file(path, text); };
  write("# notes\ntets,method,acceleration,ms_per_step,ms_per_step_low,ms_per_step_high\n500,jacobi,none,1.5,1.25,2\n");
  const std::vector<SpeedRow> rows = read_speeds(path);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].name == "500 tets, jacobi + none");
  CHECK(rows[0].ms.median == 1.5);
  CHECK(rows[0].ms.low == 1.25);
  CHECK(rows[0].ms.high == 2);
  write("# notes\n");
  CHECK(error_of(path) == "speed.csv: has no rows; expected a speed.csv of fascia bench speed");
  write("tets,method\n500,jacobi\n");
  CHECK(error_of(path) == "speed.csv:2: no column acceleration; expected a speed.csv of fascia bench speed");
  write("tets,method,acceleration,ms_per_step,ms_per_step_low,ms_per_step_high\n500,jacobi,none,fast,1,2\n");
  CHECK(error_of(path) == "speed.csv:2: ms_per_step is fast; expected a speed.csv of fascia bench speed");
  write("tets,method,acceleration,ms_per_step,ms_per_step_low,ms_per_step_high\n500,jacobi,none,1\n");
  CHECK(error_of(path) == "speed.csv:2: no ms_per_step_low; expected a speed.csv of fascia bench speed");
}
