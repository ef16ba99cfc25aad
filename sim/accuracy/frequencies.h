// Natural frequencies of small vibrations about rest.
#pragma once
#include <Eigen/Core>

#include "sim/model/model.h"

namespace fascia {

/// The lowest `count` frequencies [Hz] of a body with supports, ascending, with the masses of the solvers: inverse
/// iteration on a subspace (Bathe, Wilson 1972), to about ten digits. Empty if the stiffness at rest is singular.
Eigen::VectorXd natural_frequencies(const Model& model, int count);

}  // namespace fascia
