// Selection by --only.
#include "app/cli/name_pattern.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("a pattern is a part of a name, with * and ? as in file names") {
  CHECK(matches("liver, two_level", ""));
  CHECK(matches("liver, two_level", "liver"));
  CHECK(matches("liver, two_level", "two"));
  CHECK(matches("liver, two_level", "l*l"));
  CHECK(matches("liver, two_level", "l?ver"));
  CHECK(matches("liver, two_level", "[kl]iver"));
  CHECK(matches("a/b", "*"));
  CHECK(matches("a/b", "a*b"));  // / is an ordinary character
  CHECK(matches("", ""));
  CHECK_FALSE(matches("liver, two_level", "Liver"));
  CHECK_FALSE(matches("liver, two_level", "two_level, liver"));
  CHECK_FALSE(matches("liver", "l?iver"));
  CHECK_FALSE(matches("", "x"));
}
