#include <catch2/catch.hpp>

#include "sim/fit/measured/unit.h"

namespace fascia {

TEST_CASE("units of columns", "[fit]") {
  CHECK(find_unit("mN")->size == 1e-3);
  CHECK(find_unit("mm")->dimension == Dimension::length);
  CHECK(find_unit("min")->size == 60);
  CHECK(find_unit("lbf") == nullptr);
  CHECK(find_unit("MM") == nullptr);
  CHECK(unit_names(Dimension::force) == "N, mN, kN");
  CHECK(std::string(si_unit(Dimension::length)) == "m");
}

}  // namespace fascia
