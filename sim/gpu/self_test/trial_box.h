// The body of the self-test, and a state of it in which every vertex has another displacement.
#pragma once
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

Material trial_tissue(MaterialModel law, double damping = 0);
/// A box of 0.1 m, held at x = 0, of 480 linear tets, or of 162 quadratic ones.
Model trial_box(const Material& material, bool quadratic = false);
/// Displacements and velocities of about `amplitude` [m], zero where held.
State trial_state(const Model& model, double amplitude);
/// RMS of a - b over the RMS of b; infinite for a that is not finite.
double relative_deviation(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b);

}  // namespace fascia
