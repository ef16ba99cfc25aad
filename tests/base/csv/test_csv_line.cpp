// Lines of CSV files.
#include "base/csv/csv_line.h"

#include <catch2/catch.hpp>

using namespace fascia;
using Cells = std::vector<std::string_view>;

TEST_CASE("a line is split at its commas, and blanks around cells go") {
  CHECK(csv_cells("a,b,c") == Cells{"a", "b", "c"});
  CHECK(csv_cells(" 1 ,\t2.5e-3,x y\r") == Cells{"1", "2.5e-3", "x y"});
}

TEST_CASE("empty cells count, at the end of a line too") {
  CHECK(csv_cells("") == Cells{""});
  CHECK(csv_cells("a,,") == Cells{"a", "", ""});
  CHECK(csv_cells(",") == Cells{"", ""});
}

TEST_CASE("text is trimmed at both ends") {
  CHECK(trimmed("  a b \r") == "a b");
  CHECK(trimmed(" \t\r").empty());
  CHECK(trimmed("").empty());
}
