// The table of settings.
#include <catch2/catch.hpp>

#include "sim/scene/settings/solver_settings.h"

using namespace fascia;

TEST_CASE("every default is in its range and every setting has a help text") {
  SolverSettings settings;
  int count = 0;
  visit_settings(settings, [&](auto& field, const char* name, const char*, auto min, auto max, bool logarithmic,
                               const char* help) {
    CAPTURE(name);
    CHECK(field >= min);
    CHECK(field <= max);
    if (logarithmic) CHECK(min > 0);
    CHECK(std::string(help).size() > 10);
    ++count;
  });
  CHECK(count == 9);
  CHECK(SolverChoice{settings.method, settings.acceleration} == solver_choices().front());
}

TEST_CASE("a substep is an equal part of the step") {
  SolverSettings settings;
  settings.time_step = 0.5;
  settings.substeps = 4;
  CHECK(settings.substep() == 0.125);
}
