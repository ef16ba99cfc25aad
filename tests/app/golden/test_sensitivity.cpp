// Goldens of chaotic motion: what a nudge by rounding changes widens their limits, unless someone chose those.
#include "app/golden/sensitivity.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Outcome outcome_with(const std::vector<Eigen::Vector3d>& displacement, unsigned char gray, double force) {
  Outcome outcome;
  outcome.picture = {2, 1, {gray, gray, gray, 255, 0, 0, 0, 255}};
  outcome.fields.displacement = displacement;
  outcome.size = 2;
  outcome.contact = {{"ground", {0, force, 0}}};
  return outcome;
}

}  // namespace

TEST_CASE("the sensitivity is the difference of two outcomes in the units of the limits") {
  const Outcome a = outcome_with({{0, 0, 0}, {0, 1, 0}}, 100, 10), b = outcome_with({{0, 0, 0}, {0, 1, 0.5}}, 151, 12);
  const Sensitivity found = sensitivity_of(a, b);
  CHECK(found.state == Approx(0.25));
  CHECK(found.mean == Approx(0.2 * 3 / 8));  // 51 of 255 in three of eight channels
  CHECK(found.share == Approx(0.5));
  CHECK(found.contact == Approx(0.2));
  const Sensitivity none = sensitivity_of(a, a);
  CHECK(none.state + none.mean + none.share + none.contact == 0);
}

TEST_CASE("default limits are widened to ten times the sensitivity; chosen and larger ones stay") {
  Sensitivity sensitivity;
  sensitivity.state = 1e-3;
  sensitivity.mean = 1e-6;
  GoldenLimits limits;
  CHECK(widened(limits, sensitivity).state == Approx(1e-2));
  CHECK(widened(limits, sensitivity).mean == limits.mean);
  limits.state = 1e-4;
  CHECK(widened(limits, sensitivity).state == 1e-4);
}

TEST_CASE("the sensitivity is stored beside the goldens while it widens a limit") {
  const TemporaryFolder folder;
  const GoldenFiles goldens{folder / "a.golden.png", folder / "a.golden.csv"};
  const std::filesystem::path file = folder / "a.golden.sensitivity.csv";
  CHECK(sensitivity_beside(goldens) == file);
  CHECK(sensitivity_beside({folder / "b.golden.png", {}}) == folder / "b.golden.sensitivity.csv");
  CHECK(read_sensitivity(goldens).state == 0);
  Sensitivity sensitivity{1e-5, 2e-5, 9e-7, 1e-5};
  CHECK(update_sensitivity(sensitivity, goldens).empty());  // a tenth of every limit, at most
  CHECK_FALSE(std::filesystem::exists(file));
  sensitivity.state = 0.012;
  std::vector<std::string> lines = update_sensitivity(sensitivity, goldens);
  REQUIRE(lines.size() == 1);
  CHECK(contains(lines[0], "to 0.012 of the scene's size"));
  CHECK(contains(lines[0], "at most 0.12 and 0.00196 are permitted"));
  const Sensitivity read = read_sensitivity(goldens);
  CHECK(read.mean == 1e-5);
  CHECK(read.share == 2e-5);
  CHECK(read.state == 0.012);
  CHECK(read.contact == 1e-5);
  CHECK(contains(update_sensitivity(sensitivity, goldens).at(0), ": unchanged"));
  sensitivity.state = 0;
  CHECK(contains(update_sensitivity(sensitivity, goldens).at(0), ": removed, rounding changes little"));
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("another file in place of a sensitivity") {
  const TemporaryFolder folder;
  const GoldenFiles goldens{folder / "a.golden.png", folder / "a.golden.csv"};
  for (const char* text : {"", "mean,share,state,contact\n", "mean,share,state,contact\n1,2,3\n", "x\n1,2,3,4\n",
                           "mean,share,state,contact\n1,2,-3,4\n", "mean,share,state,contact\n1,2,nan,4\n"}) {
    CAPTURE(text);
    write_file(sensitivity_beside(goldens), text);
    CHECK_THROWS_WITH(read_sensitivity(goldens),
                      Catch::Contains("a.golden.sensitivity.csv: is no sensitivity of a golden"));
    CHECK(contains(compare(Outcome(), goldens, {}).findings.at(0).text, "is no sensitivity of a golden"));
  }
}
