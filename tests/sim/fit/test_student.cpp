#include <catch2/catch.hpp>
#include <limits>

#include "sim/fit/student.h"

namespace fascia {

// Two-sided 95 % points of the table in Abramowitz, Stegun 1964, 26.10.
TEST_CASE("Student's t has the quantiles of its table", "[fit]") {
  constexpr double kRounded = 5.1e-4;  // of the table's three decimals
  CHECK(student_95(1) == Approx(12.706).margin(kRounded));
  CHECK(student_95(2) == Approx(4.303).margin(kRounded));
  CHECK(student_95(5) == Approx(2.571).margin(kRounded));
  CHECK(student_95(30) == Approx(2.042).margin(kRounded));
  CHECK(student_95(120) == Approx(1.980).margin(kRounded));
  CHECK(student_95(std::numeric_limits<double>::infinity()) == Approx(1.960).margin(kRounded));
}

}  // namespace fascia
