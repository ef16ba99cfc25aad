// fascia verify: a short form of the suite, its report and its exit code.
#include <catch2/catch.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("verify passes its quick tests and writes a report with the source of every truth", "[verify]") {
  const TemporaryFolder folder;
  const CommandResult result = run_fascia({"verify", "--only", "patches,frequencies,orders_time,estimates_time,twist",
                                           "--out", folder.path().string(), "--context", "osmesa"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const std::string table = read_file(folder / "verify.csv"), report = read_file(folder / "report.html");
  CHECK(table.find("test,case,value,unit,low,high,result,truth") != std::string::npos);
  CHECK(table.find("failed") == std::string::npos);
  for (const char* test : {"Patch test", "Natural frequencies", "Orders of convergence in time",
                           "Estimated error in time", "Twisting column"}) {
    CAPTURE(test);
    CHECK(table.find(test) != std::string::npos);
    CHECK(report.find(std::string("<h2>") + test) != std::string::npos);
  }
  CHECK(report.find("Cook") == std::string::npos);
}

TEST_CASE("verify refuses an unknown test and has no default folder", "[verify]") {
  CHECK(run_fascia({"verify", "--only", "patch", "--out", "x"}).exit_code == 2);
  CHECK(run_fascia({"verify"}).exit_code == 2);
}
