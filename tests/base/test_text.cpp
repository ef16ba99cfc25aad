// Words and numbers of reports.
#include "base/text.h"

#include <catch2/catch.hpp>
#include <sstream>

using namespace fascia;

TEST_CASE("numbers have four digits") {
  CHECK(number(0) == "0");
  CHECK(number(1234.56) == "1235");
  CHECK(number(123456) == "1.235e+05");
  CHECK(number(-0.000123456) == "-0.0001235");
  CHECK(point({1, -0.25, 1e-9}) == "(1, -0.25, 1e-09)");
}

TEST_CASE("one item has no plural, and vertices have an irregular one") {
  CHECK(plural(0, "tet") == "0 tets");
  CHECK(plural(1, "tet") == "1 tet");
  CHECK(plural(2, "tet") == "2 tets");
  CHECK(plural(1, "vertex") == "1 vertex");
  CHECK(plural(0, "vertex") == "0 vertices");
  CHECK(plural(12, "vertex") == "12 vertices");
}

TEST_CASE("a length has the largest unit of which it is one or more") {
  CHECK(length(2500) == "2.5 km");
  CHECK(length(1) == "1 m");
  CHECK(length(0.999) == "999 mm");
  CHECK(length(1e-3) == "1 mm");
  CHECK(length(0.00025) == "250 um");
  CHECK(length(2e-9) == "2e-09 m");
  CHECK(length(0) == "0 m");
  CHECK(length_in("m", 0.25) == "250 mm");
  CHECK(length_in("mm", 0.25) == "0.25 mm");  // the unit of the file
}

TEST_CASE("labels fill a column, and a longer label keeps a blank behind it") {
  std::ostringstream out;
  line(out, "box") << "1\n";
  line(out, "") << "2\n";
  line(out, "twelve chars") << "3\n";
  CHECK(out.str() == "box         1\n            2\ntwelve chars 3\n");
}
