// How a mesh that is opened on its own becomes a scene: what its file does not state, and why it was chosen so. The
// values are also in the scene, where a saved scene has them as explicit keys (sim/bare_mesh/plan.h makes the plan).
#pragma once
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

struct BareMeshPlan {
  LengthUnit unit = LengthUnit::m;
  UpAxis up = UpAxis::y;
  std::vector<Selection> fixed;
  double young_modulus = 0;  // [Pa]
  MaterialModel law = Material().model;

  // One short reason each, as in "mm: 120 mm wide".
  std::string unit_reason, up_reason, support_reason, stiffness_reason;
  std::vector<std::string> overrides;  // Unsettled::overrides
};

}  // namespace fascia
