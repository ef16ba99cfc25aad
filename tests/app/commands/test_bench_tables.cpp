// Benchmarks whose quick form takes seconds: their tables are complete.
// Covers: bench, app/bench/contact, app/bench/contact_probe, app/bench/dispatch, app/bench/static_times
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>

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

TEST_CASE("bench contact has the cost of every tool, none far away, and iterations for every shape") {
  const TemporaryFolder folder;
  const CommandResult result = run_fascia({"bench", "contact", "--quick", "--out", "out", "--quiet"}, folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const std::string cost = read_file(folder / "out/contact_cost.csv"),
                    iterations = read_file(folder / "out/contact_iterations.csv"),
                    probe = read_file(folder / "out/contact_probe.csv");
  INFO(cost << iterations << probe);
  CHECK_THAT(cost, Catch::Contains(",far away,0,"));
  CHECK(std::count(cost.begin(), cost.end(), '\n') == 5 + std::count(cost.begin(), cost.end(), '#') + 1);
  for (const char* shape : {"\nsphere,4,", "\ncapsule,4,", "\nbox,4,", "\ncylinder,4,"})
    CHECK_THAT(iterations, Catch::Contains(shape));
  double errors[2] = {1, 1};  // of exact steps, and of 20 iterations
  std::sscanf(probe.c_str() + probe.find("\nexact steps,"), "\nexact steps,12,%lf", &errors[0]);
  std::sscanf(probe.c_str() + probe.find("\n20 iterations,"), "\n20 iterations,12,%lf", &errors[1]);
  CHECK(errors[0] < 0.2);  // in the few steps after the first touch
  CHECK(errors[1] == Approx(errors[0]).epsilon(0.01));
}

TEST_CASE("bench dispatch has a row for each size of work and number of buffers, whose chains count to their length") {
  for (const char* loads : {"ssbo", "texel"}) {
    const TemporaryFolder folder;
    const CommandResult result =
        run_fascia({"bench", "dispatch", "--quick", "--loads", loads, "--out", "out"}, folder.path());
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const std::string table = read_file(folder / "out/dispatch.csv");
    INFO(table);
    for (const char* work_items : {"1", "64", "1024", "16384"})
      for (const char* buffers : {"1", "4", "8", "14"}) {
        const std::string start = std::string("\n") + work_items + ',' + buffers + ",20,20,";
        CHECK_THAT(table, Catch::Contains(start));
        CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 18);
      }
  }
}
