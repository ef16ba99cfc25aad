#include "app/bench/accuracy/grid.h"

#include <algorithm>

#include "app/ui/units.h"

namespace fascia {
namespace {

std::vector<AccuracyCase> full_cases() {
  using S = AccuracyScenario;
  std::vector<AccuracyCase> cases;
  for (const S scenario : {S::one_step, S::grabbed, S::pressed, S::settled}) {
    AccuracyCase base;
    base.scenario = scenario;
    const auto add = [&](const auto& vary) {
      cases.push_back(base);
      vary(cases.back());
    };
    add([](AccuracyCase&) {});
    for (const double young_modulus : {1e5, 1e7, 1e9}) add([=](AccuracyCase& c) { c.young_modulus = young_modulus; });
    for (const double poisson_ratio : {0.45, 0.49}) add([=](AccuracyCase& c) { c.poisson_ratio = poisson_ratio; });
    add([](AccuracyCase& c) { c.substeps = 4; });
    if (scenario != S::one_step) continue;  // the exact solution of many steps of a large mesh takes hours
    for (const Eigen::Vector3i& cells : {Eigen::Vector3i(36, 9, 9), Eigen::Vector3i(64, 16, 16)})
      add([&](AccuracyCase& c) { c.cells = cells; });
  }
  return cases;
}

std::vector<AccuracyCase> quick_cases() {
  using S = AccuracyScenario;
  const Eigen::Vector3i small(16, 4, 4), tiny(8, 2, 2);
  return {{S::one_step, small, 1e6, 0.3, 1},
          {S::one_step, small, 1e7, 0.3, 1},
          {S::pressed, small, 1e6, 0.3, 1},
          {S::settled, tiny, 1e6, 0.3, 1}};
}

}  // namespace

const char* name_of(AccuracyScenario scenario) {
  switch (scenario) {
    case AccuracyScenario::one_step:
      return "one_step";
    case AccuracyScenario::grabbed:
      return "grabbed";
    case AccuracyScenario::pressed:
      return "pressed";
    case AccuracyScenario::settled:
      return "settled";
  }
  return "";
}

std::string title_of(const AccuracyCase& c) {
  return std::string(name_of(c.scenario)) + ", " + std::to_string(c.tets()) +
         " tets, E = " + engineering(c.young_modulus, "Pa") + ", nu = " + engineering(c.poisson_ratio, "") + ", " +
         std::to_string(c.substeps) + (c.substeps == 1 ? " substep" : " substeps");
}

std::string file_name_of(const AccuracyCase& c) {
  std::string name = std::string("accuracy_") + name_of(c.scenario) + "_" + std::to_string(c.tets()) + "_" +
                     engineering(c.young_modulus, "Pa", 7) + "_nu" + engineering(c.poisson_ratio, "", 7) + "_s" +
                     std::to_string(c.substeps);
  std::erase(name, ' ');
  return name;
}

SolverSettings settings_of(const AccuracyCase& measured, const SolverChoice& pair, int iterations) {
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.iterations = iterations;
  settings.substeps = measured.substeps;
  return settings;
}

std::vector<SolverChoice> AccuracyGrid::pairs_of(const AccuracyCase& measured) const {
  std::vector<SolverChoice> able;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(able), [&](const SolverChoice& pair) {
    return measured.scenario != AccuracyScenario::pressed || info_of(pair.method).carries_contact;
  });
  return able;
}

const std::vector<int>& AccuracyGrid::iterations_of(const AccuracyCase& measured) const {
  return measured.scenario == AccuracyScenario::settled ? settled_iterations : iterations;
}

int AccuracyGrid::steps_of(const AccuracyCase& measured) const {
  return measured.scenario == AccuracyScenario::settled ? settled_steps : 1;
}

AccuracyGrid accuracy_grid(bool quick) {
  AccuracyGrid grid;
  grid.pairs = solver_choices();
  if (quick) {
    grid.cases = quick_cases();
    grid.iterations = {1, 2, 5, 10, 20, 40};
    grid.settled_iterations = {1, 5, 20};
    grid.settled_steps = 30;
    grid.repetitions = 5;
  } else {
    grid.cases = full_cases();
    grid.iterations = {1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 75, 100, 150, 200};
    grid.settled_iterations = {1, 2, 5, 10, 20, 40};
  }
  return grid;
}

}  // namespace fascia
