// The stiffness with which a body carries its own weight visibly and safely, from linear elasticity.
#pragma once
#include <vector>

#include "sim/material/material.h"
#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// A placed body, y up, and what holds it.
struct HeldBody {
  std::vector<Eigen::Vector3d> positions;  // [m]
  std::vector<Tet> tets;                   // positive volume
  std::vector<std::uint32_t> fixed;
};

/// The answer of a body to its weight in linear elasticity, for a modulus of 1 Pa: divided by Young's modulus it is the
/// answer of that material.
struct WeightResponse {
  double strain = 0;  // [-] Frobenius norm that a hundredth of the volume exceeds
  double peak = 0;    // [-] the largest one
  double sag = 0;     // [-] displacement that a hundredth of the mass exceeds, over the size of the body's box
  // [-] the same displacement under gravity from the side over the height; near 1 a column buckles under its own
  // weight, and a body that lies on a narrow strip rolls off it
  double sway = 0;
};

/// `material` without its modulus; `gravity` [m/s^2]. Meshes of more than some 20,000 tets are replaced by a coarser
/// filling of their boundary.
WeightResponse weight_response(HeldBody body, const Material& material, double gravity);

/// Young's modulus [Pa] of two digits with which the weight strains the body by some percent and collapses nothing.
double modulus_for(const WeightResponse& response);

}  // namespace fascia
