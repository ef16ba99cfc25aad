#include "sim/integrators/integrator.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// BDF2 is unstable where steps grow by more than 1 + sqrt 2 (Grigorieff 1983).
constexpr double kMostGrowth = 2;

}  // namespace

const std::vector<IntegratorInfo>& integrators() {
  static const std::vector<IntegratorInfo> table{
      {Integrator::implicit_euler, "implicit_euler", "Implicit Euler",
       "First order in time: the most robust, and damps motion as if the tissue were viscous, the more the longer the "
       "step",
       1, false, false},
      {Integrator::bdf2, "bdf2", "BDF2",
       "Second order in time at the cost of implicit Euler: motion keeps its energy and its period. Give tissue a "
       "damping of its own, since the step hardly damps any more",
       1, true, true},
      {Integrator::sdirk2, "sdirk2", "SDIRK2",
       "Second order in time, two solves a substep: the least damping. It amplifies what unfinished iterations leave: "
       "for many iterations",
       2, true, false}};
  return table;
}

const IntegratorInfo& info_of(Integrator integrator) {
  return *std::find_if(integrators().begin(), integrators().end(),
                       [&](const IntegratorInfo& info) { return info.integrator == integrator; });
}

std::optional<Integrator> find_integrator(std::string_view name) {
  for (const IntegratorInfo& info : integrators())
    if (name == info.name) return info.integrator;
  return std::nullopt;
}

std::vector<IntegratorStage> stages_of(Integrator integrator, double h, double earlier) {
  switch (integrator) {
    case Integrator::implicit_euler:
      return {IntegratorStage{h}};
    case Integrator::bdf2: {
      double r = earlier > 0 ? h / earlier : 0;
      if (r > kMostGrowth) r = 0;
      return {IntegratorStage{h * (1 + r) / (1 + 2 * r), r * r / (1 + 2 * r), h}};
    }
    case Integrator::sdirk2: {
      const double g = 1 - std::sqrt(0.5);
      return {IntegratorStage{g * h, 0, g * h, 1 - g}, IntegratorStage{g * h, 1 / g - 2, h - g * h, g}};
    }
  }
  return {};
}

}  // namespace fascia
