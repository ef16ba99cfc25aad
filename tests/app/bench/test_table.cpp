// Tables of benchmarks as CSV.
#include "app/bench/table.h"

#include <catch2/catch.hpp>
#include <limits>

#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;

TEST_CASE("cells are texts, exact integers and numbers of seven digits") {
  CHECK(Cell().text().empty());
  CHECK(Cell("a b").text() == "a b");
  CHECK(Cell(std::string("c")).text() == "c");
  CHECK(Cell(-12).text() == "-12");
  CHECK(Cell(std::uint64_t{18446744073709551615u}).text() == "18446744073709551615");
  CHECK(Cell(0.1).text() == "0.1");
  CHECK(Cell(1.0 / 3).text() == "0.3333333");
  CHECK(Cell(123456789.0).text() == "1.234568e+08");
  CHECK(Cell(std::numeric_limits<double>::infinity()).text() == "nan");
  CHECK(Cell(std::numeric_limits<double>::quiet_NaN()).text() == "nan");
}

TEST_CASE("a table has its notes, the names of its columns and its rows") {
  const test::TemporaryFolder folder;
  Table table;
  table.notes = {"made here", "twice"};
  table.columns = {"name", "tets", "time_ms"};
  table.rows = {{"small", 12, 0.25}, {"none", 0, {}}};
  write_table(folder / "t.csv", table);
  CHECK(read_file(folder / "t.csv") == "# made here\n# twice\nname,tets,time_ms\nsmall,12,0.25\nnone,0,\n");
  CHECK_THROWS_AS(write_table(folder / "none/t.csv", table), Error);
}

TEST_CASE("a table for readers has columns of equal width") {
  Table table;
  table.columns = {"name", "time"};
  table.rows = {{"small", 0.25}, {"none", {}}};
  CHECK(aligned(table) == " name  time\nsmall  0.25\n none      \n");
}
