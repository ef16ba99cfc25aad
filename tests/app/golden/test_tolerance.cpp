// Tolerances as users write them.
#include "app/golden/tolerance.h"

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace fascia;

TEST_CASE("tolerances are numbers or quotients") {
  CHECK(parse_tolerance("0.5/255", "x") == 0.5 / 255);
  CHECK(parse_tolerance("2e-3", "x") == 2e-3);
  CHECK(parse_tolerance("0", "x") == 0);
  for (const char* wrong : {"", "-1", "2", "1/0", "1/", "/2", "1/2/3", "0.1 ", "nan"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_tolerance(wrong, "x"), Error);
  }
}

TEST_CASE("the error of a refused tolerance has its place and the expected value") {
  CHECK_THROWS_WITH(parse_tolerance("1/0", "check.json: defaults.max_mean"),
                    "check.json: defaults.max_mean: is 1/0; expected a share from 0 to 1, such as 0.002 or 0.5/255");
  CHECK_THROWS_WITH(parse_tolerance("a\nb", "--x"), Catch::StartsWith("--x: is \"a\\nb\";"));
  CHECK(parse_tolerance("1", "x") == 1);
  CHECK(parse_tolerance("3/4", "x") == 0.75);
}

TEST_CASE("measured values are printed with three digits") {
  CHECK(three_digits(0.0019607) == "0.00196");
  CHECK(three_digits(1) == "1");
  CHECK(three_digits(123456) == "1.23e+05");
}
