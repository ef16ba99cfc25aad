// The model that the coarse space sees: quadratic tets cut into linear ones, since coarse functions are much wider than
// a tet and see the same tissue.
#pragma once
#include "sim/model/model.h"

namespace fascia {

/// The part of the model that determines coarse space and matrix, with linear tets over all of its vertices. `relaxed`:
/// those of quadratic tets have K as the iterations see it (shaders/sim/quadratic/quadratic_multiplier.comp).
Model linear_model(const Model& model, bool relaxed = false);

/// Whether there are quadratic tets whose K would be relaxed.
bool has_large_bulk(const Model& model);

}  // namespace fascia
