// Methods and accelerations: the legal pairs, the settings that act on each, and the laws that each method supports.
#include "sim/scene/settings/solver_choice.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "base/error.h"
#include "sim/scene/settings/solver_settings.h"

using namespace fascia;

TEST_CASE("a legal pair is found by its names, the best one by one of them or none") {
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

TEST_CASE("every method and acceleration is in its table once, and in a pair") {
  std::set<Method> methods_seen;
  for (const MethodInfo& info : methods()) {
    CAPTURE(info.name);
    CHECK(methods_seen.insert(info.method).second);
    CHECK(&info_of(info.method) == &info);
    CHECK(!info.accelerations.empty());
    CHECK(info.dispatches > 0);
  }
  std::set<Acceleration> paired, seen;
  for (const SolverChoice& choice : solver_choices()) paired.insert(choice.acceleration);
  for (const AccelerationInfo& info : accelerations()) {
    CAPTURE(info.name);
    CHECK(seen.insert(info.acceleration).second);
    CHECK(&info_of(info.acceleration) == &info);
    CHECK(paired.count(info.acceleration) == 1);
  }
}

TEST_CASE("pairs of the paper are those of its methods, in the order of all pairs") {
  const std::vector<SolverChoice> paper = i3d2019_choices();
  CHECK(!paper.empty());
  auto next = paper.begin();
  for (const SolverChoice& choice : solver_choices()) {
    const bool in_paper = choice.method == Method::jacobi || choice.method == Method::mass_splitting ||
                          choice.method == Method::gauss_seidel;
    CAPTURE(name_of(choice.method), name_of(choice.acceleration), in_paper);
    if (!in_paper) continue;
    REQUIRE(next != paper.end());
    CHECK(*next++ == choice);
  }
  CHECK(next == paper.end());
}

TEST_CASE("a setting of one method or acceleration does nothing with others, all other settings always act") {
  const SolverChoice sweep{Method::gauss_seidel, Acceleration::none}, weighted{Method::jacobi, Acceleration::chebyshev},
      combined{Method::vertex_descent, Acceleration::anderson},
      positions{Method::jacobi, Acceleration::anderson_positions}, plain{Method::two_level, Acceleration::none};
  for (const SolverChoice& choice : {sweep, weighted, combined, positions, plain}) {
    CAPTURE(name_of(choice.method), name_of(choice.acceleration));
    CHECK(applies("colors", choice) == (choice == sweep));
    CHECK(applies("spectral_radius", choice) == (choice == weighted));
    CHECK(applies("window", choice) == (choice == combined || choice == positions));
    CHECK(applies("iterations", choice));
    CHECK(applies("rest_speed", choice));
  }
}

TEST_CASE("every setting that belongs to a method or an acceleration exists") {
  std::set<std::string> names;
  SolverSettings settings;
  visit_settings(settings, [&](auto&, const char* name, auto&&...) { names.insert(name); });
  const auto check = [&](const auto& table) {
    for (const auto& info : table)
      for (const std::string_view setting : info.settings) {
        CAPTURE(info.name, setting);
        CHECK(names.count(std::string(setting)) == 1);
      }
  };
  check(methods());
  check(accelerations());
}

TEST_CASE("methods of XPBD carry the laws of the Green strain alone, the others every law") {
  for (const MethodInfo& info : methods()) {
    const bool every = info.method == Method::two_level || info.method == Method::vertex_descent;
    CAPTURE(info.name);
    CHECK(carries(info.method, MaterialModel::st_venant_kirchhoff));
    CHECK(carries(info.method, MaterialModel::neo_hookean) == every);
    CHECK(carries(info.method, MaterialModel::mooney_rivlin) == every);
    CHECK(carries(info.method, MaterialModel::stable_neo_hookean) == every);
  }
  Material plain, other;
  plain.model = MaterialModel::st_venant_kirchhoff;
  other.model = MaterialModel::neo_hookean;
  CHECK_NOTHROW(require_carried(Method::jacobi, {plain, plain}, "s.json"));
  CHECK_NOTHROW(require_carried(Method::two_level, {plain, other}, "s.json"));
  CHECK_THROWS_WITH(
      require_carried(Method::jacobi, {plain, other}, "s.json: solver.method"),
      "s.json: solver.method: jacobi does not support the material model neo_hookean; expected one of the "
      "methods that do: two_level, vertex_descent");
  CHECK(refusal(Method::jacobi, {plain, plain}, false).empty());
  CHECK(refusal(Method::jacobi, {plain, other}, false) ==
        "Needs a material of the model St. Venant-Kirchhoff, and this scene has Neo-Hookean.");
  CHECK(refusal(Method::jacobi, {plain}, true) == "Needs linear elements, and this scene has quadratic ones.");
  CHECK(refusal(Method::two_level, {plain, other}, true).empty());
}
