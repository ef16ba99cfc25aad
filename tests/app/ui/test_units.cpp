#include <catch2/catch.hpp>

#include "app/ui/units.h"

using fascia::engineering;
using fascia::parse_engineering;

TEST_CASE("numbers are shown with SI prefixes if their unit permits") {
  CHECK(engineering(12500, "Pa") == "12.5 kPa");
  CHECK(engineering(1e10, "Pa") == "10 GPa");
  CHECK(engineering(999.96, "Pa") == "1 kPa");
  CHECK(engineering(1.0 / 60, "s") == "16.7 ms");
  CHECK(engineering(-3.21, "N") == "-3.21 N");
  CHECK(engineering(2.5e-7, "J") == "250 nJ");
  CHECK(engineering(0.000214, "Nm") == "214 \xc2\xb5Nm");
  CHECK(engineering(1.5e-5, "m/s") == "15 \xc2\xb5m/s");
  CHECK(engineering(0, "N") == "0 N");
  CHECK(engineering(1060, "kg/m^3") == "1060 kg/m^3");
  CHECK(engineering(0.3, "") == "0.3");
  CHECK(engineering(-0.0499, "") == "-0.0499");
  CHECK(engineering(NAN, "N") == "-");
  CHECK(fascia::bytes_text(1536) == "1.5 KiB");
}

TEST_CASE("typed text is parsed") {
  CHECK(parse_engineering("12.5 kPa", "Pa") == 12500);
  CHECK(parse_engineering("12.5k", "Pa") == 12500);
  CHECK(parse_engineering(" +3e4 ", "Pa") == 3e4);
  CHECK(parse_engineering("1 Pa", "Pa") == 1);
  CHECK(*parse_engineering("16.7ms", "s") == Approx(0.0167));
  CHECK(*parse_engineering("2 \xc2\xb5s", "s") == Approx(2e-6));
  CHECK(parse_engineering("-0.2", "") == -0.2);
  CHECK(parse_engineering("2.5 m/s", "m/s") == 2.5);
  CHECK(*parse_engineering("15 mm/s", "m/s") == Approx(0.015));
  for (const char* wrong : {"", "k", "12 kPaa", "1,5", "nan", "inf", "12 N", "0x10"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_engineering(wrong, "Pa"));
  }
  CHECK_FALSE(parse_engineering("3k", "kg/m^3"));
}

TEST_CASE("displayed numbers read back") {
  for (double value = 1.3e-9; value < 1e12; value *= 7.7) {
    const std::string text = engineering(value, "Pa", 4);
    CAPTURE(value, text);
    REQUIRE(parse_engineering(text, "Pa"));
    CHECK(*parse_engineering(text, "Pa") == Approx(value).epsilon(5e-4));
  }
}
