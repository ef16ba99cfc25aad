// The cases of `fascia bench accuracy`: one beam in four situations, and around a base case (5,184 tets, E = 1e6 Pa,
// nu = 0.3, 1/60 s in one substep) one parameter at a time, because the full product would take days and add little
// information.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/scene/settings/solver_settings.h"

namespace fascia {

enum class AccuracyScenario {
  one_step,  // a step from a smooth bend and twist at rest
  grabbed,   // a step from rest in which the free end is displaced sideways by 0.3 of the length
  pressed,   // a step in which an instrument that presses the beam onto the ground moves on
  settled    // many steps from rest under gravity
};
const char* name_of(AccuracyScenario scenario);  // "one_step", as in tables

struct AccuracyCase {
  AccuracyScenario scenario = AccuracyScenario::one_step;
  Eigen::Vector3i cells{24, 6, 6};  // of the beam, 6 tets each
  double young_modulus = 1e6;       // [Pa]
  double poisson_ratio = 0.3;
  int substeps = 1;

  int tets() const { return 6 * cells.prod(); }
};
std::string title_of(const AccuracyCase& measured);      // for display
std::string file_name_of(const AccuracyCase& measured);  // different for different cases
SolverSettings settings_of(const AccuracyCase& measured, const SolverChoice& pair, int iterations);

struct AccuracyGrid {
  std::vector<SolverChoice> pairs;
  std::vector<AccuracyCase> cases;
  std::vector<int> iterations;          // per substep, for single steps, ascending
  std::vector<int> settled_iterations;  // per substep, of every step of `settled`, ascending
  int settled_steps = 120;
  int repetitions = 7;  // of every timed step

  /// Of `pairs`, those that can solve the case: few methods carry contact.
  std::vector<SolverChoice> pairs_of(const AccuracyCase& measured) const;
  const std::vector<int>& iterations_of(const AccuracyCase& measured) const;
  int steps_of(const AccuracyCase& measured) const;
};
AccuracyGrid accuracy_grid(bool quick);

}  // namespace fascia
