// Builds what the solvers simulate from a scene: its bodies and the grabs that its script lets take hold of them.
#pragma once
#include "base/progress.h"
#include "sim/model/model.h"

namespace fascia {

/// Reads the meshes, surfaces and CSV files of the scene. Throws Error for anything unreadable, a selection of nothing,
/// a material key that names no region, prescribed targets that miss vertices, a grab that has nothing to hold.
Model build_model(const Scene& scene, const Progress& progress = {});
/// The same from meshes in memory, [body] (sim/model/model.h).
Model build_model(const Scene& scene, std::vector<TetMesh> meshes);

}  // namespace fascia
