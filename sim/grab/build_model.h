// Builds the model that the solvers simulate from a scene: its bodies and the scripted grabs, resolved to vertices.
#pragma once
#include "base/progress.h"
#include "sim/model/model.h"

namespace fascia {

/// Reads the meshes, surfaces and CSV files of the scene. Throws Error for an unreadable file, an empty selection, a
/// material key that names no region, prescribed targets that miss vertices, or a grab without vertices to pull.
Model build_model(const Scene& scene, const Progress& progress = {}, const BodyRead& read = {});
/// The same from meshes in memory, [body] (sim/model/model.h).
Model build_model(const Scene& scene, std::vector<TetMesh> meshes);

}  // namespace fascia
