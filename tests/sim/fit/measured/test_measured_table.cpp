#include <catch2/catch.hpp>
#include <cmath>

#include "base/error.h"
#include "sim/fit/measured/measured_table.h"

namespace fascia {

TEST_CASE("a table has notes, names, numbers and empty cells", "[fit]") {
  const MeasuredTable table = read_measured_table("a.csv",
                                                  "\xEF\xBB\xBF# Probe: vertex 12\n#made by hand\r\n\n time_s , "
                                                  "reaction_y_N\r\n0, 1.5e-3\n1,\n");
  REQUIRE(table.notes.size() == 1);
  CHECK(table.notes[0] == std::pair<std::string, std::string>("Probe", "vertex 12"));
  CHECK(table.names == std::vector<std::string>{"time_s", "reaction_y_N"});
  CHECK(table.header_line == 4);
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0] == std::vector<double>{0, 1.5e-3});
  CHECK(table.rows[1][0] == 1);
  CHECK(std::isnan(table.rows[1][1]));
}

TEST_CASE("a wrong table is one line that names its place", "[fit]") {
  const auto read = [](const char* content) { read_measured_table("a.csv", content); };
  CHECK_THROWS_WITH(read("time_s,probe_x_m\n0,1,2\n"), "a.csv:2: has 3 cells; expected 2 as in line 1");
  CHECK_THROWS_WITH(read("time_s\n1,5"), "a.csv:2: has 2 cells; expected 1 as in line 1");
  CHECK_THROWS_WITH(read("time_s\n1;5"), "a.csv:2: time_s is \"1;5\"; expected a finite number or an empty cell");
  CHECK_THROWS_WITH(read("time_s\ninf"), "a.csv:2: time_s is \"inf\"; expected a finite number or an empty cell");
  CHECK_THROWS_WITH(read("# only: notes\n"),
                    "a.csv: has no rows of values; expected a line of names such as time_s,reaction_y_N and rows");
}

}  // namespace fascia
