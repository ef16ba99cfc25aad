// What fascia refine prints of a plan.
#pragma once
#include <string>

#include "app/refine/plan.h"

namespace fascia {

struct Wanted {
  double error, ms;        // relative; of a step
  double most_tets = 512;  // that a mesh may have, over those of the scene as opened
};

/// The choice within error and time, or what either alone would take. Where no choice has the error a line says so,
/// with the least error found, its largest part and what ended the search; where none has the time, with the fastest
/// one.
std::string plan_text(const Plan& plan, const Scene& scene, const Wanted& wanted);

}  // namespace fascia
