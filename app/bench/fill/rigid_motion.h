// The motion of a whole model, taken out of its initial velocities: what is left neither drifts nor spins.
#pragma once
#include "sim/model/model.h"

namespace fascia {

/// Leaves of the initial velocities what has neither momentum nor angular momentum at rest, the nearest such field in
/// the norm of the kinetic energy. For a model without held vertices and with one body.
void remove_rigid_motion(Model& model);

}  // namespace fascia
