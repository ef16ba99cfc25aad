// The table of settings, and the solver choices.
#include <catch2/catch.hpp>
#include <set>

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

TEST_CASE("a valid solver choice is found by its names, the best one by one name or none") {
  REQUIRE(!solver_choices().empty());
  CHECK(find_choice({}, {}) == solver_choices().front());
  std::set<std::pair<std::string, std::string>> seen;
  for (const SolverChoice& pair : solver_choices()) {
    const std::string method = name_of(pair.method), acceleration = name_of(pair.acceleration);
    CAPTURE(method, acceleration);
    CHECK(seen.emplace(method, acceleration).second);
    CHECK(find_choice(method, acceleration) == pair);
    CHECK(find_choice(method, {})->method == pair.method);
    CHECK(find_choice({}, acceleration)->acceleration == pair.acceleration);
    CHECK(list_of_choices().find(method + " with " + acceleration) != std::string::npos);
    CHECK(std::string(label_of(pair.method)).size() > 3);
    CHECK(std::string(help_of(pair.method)).size() > 20);
  }
  CHECK(!find_choice("warp", {}));
  CHECK(!find_choice({}, "warp"));
  CHECK(!find_choice("jacobi", ""));
}
