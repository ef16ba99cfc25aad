// --integrator and --elements: the values of their names, and none where they are not given.
#include "app/cli/discretization.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("--integrator and --elements have the values of their names") {
  CLI::App command;
  Discretization names;
  add_discretization(command, names, "of all scenes; default: their own");
  CHECK(!names.integrator());
  CHECK(!names.elements());
  command.parse("--integrator sdirk2 --elements quadratic");
  CHECK(names.integrator() == Integrator::sdirk2);
  CHECK(names.elements() == ElementOrder::quadratic);
  command.parse("--integrator bdf2 --elements linear");
  CHECK(names.integrator() == Integrator::bdf2);
  CHECK(names.elements() == ElementOrder::linear);
  CHECK_THROWS_AS(command.parse("--elements cubic"), CLI::ValidationError);

  CLI::App with_defaults;
  Discretization defaults{"bdf2", "linear"};
  add_discretization(with_defaults, defaults, "of all cases");
  with_defaults.parse("--elements quadratic");
  CHECK(defaults.integrator() == Integrator::bdf2);
  CHECK(defaults.elements() == ElementOrder::quadratic);
}
