// Benchmarks whose quick form takes seconds: their tables are complete.
// Covers: bench, app/bench/static_times
#include <algorithm>
#include <catch2/catch.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string table_of(const std::string& name) {
  const TemporaryFolder folder;
  const CommandResult result = run_fascia({"bench", name, "--quick", "--out", "out", "--quiet"}, folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return read_file(folder / ("out/" + name + ".csv"));
}

}  // namespace

TEST_CASE("bench static converges on boxes of growing size") {
  const std::string table = table_of("static");
  CHECK_THAT(table, Catch::Contains("tets,vertices,tolerance,solve_ms,iterations,newton_iterations"));
  std::size_t converged = 0;
  for (std::size_t at = table.find(",yes\n"); at != table.npos; at = table.find(",yes\n", at + 1)) ++converged;
  CHECK(converged == 2);
  CHECK(table.find(",no\n") == table.npos);
}

TEST_CASE("bench fill has a row for every shape") {
  const std::string table = table_of("fill");
  CHECK(std::count(table.begin(), table.end(), '\n') == 21);
  CHECK_THAT(table, Catch::Contains("\nspaghetti,12,"));
}
