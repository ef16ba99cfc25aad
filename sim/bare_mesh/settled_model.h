// Builds the model of a scene that may have been opened from a mesh on its own: what the mesh leaves open is settled
// first.
#pragma once
#include "base/progress.h"
#include "sim/model/model.h"

namespace fascia {

/// As build_model (sim/grab/build_model.h). A scene with `unsettled` values gets those of a plan
/// (sim/bare_mesh/plan.h), which the model keeps; a scene from a file is not changed.
Model settled_model(Scene& scene, const Progress& progress = {});

}  // namespace fascia
