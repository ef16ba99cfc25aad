// How far a state is from static equilibrium, in double precision whatever computed it.
#pragma once
#include "sim/reference/newton.h"

namespace fascia::reference {

/// Norm over the free vertices of the elastic energy's gradient minus the weight and the springs' forces, over the larger norm, of the weight or of the
/// gradient at all vertices, which at held ones is the reaction. 0 without any forces.
double static_residual(const Model& model, const State& state, const std::vector<GrabSpring>& springs = {});

}  // namespace fascia::reference
