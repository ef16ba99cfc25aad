// Writes parts of a scene as JSON documents, and a document as readable, editable text.
#pragma once
#include <nlohmann/json.hpp>

#include "sim/scene/scene.h"

namespace fascia {

/// With paths relative to `folder` (sim/scene/scene_paths.h). Without the known data of files.
nlohmann::ordered_json scene_document(const Scene& scene, const std::filesystem::path& folder);
/// The same with the known data of files.
nlohmann::ordered_json complete_document(const Scene& scene, const std::filesystem::path& folder);
nlohmann::ordered_json solver_document(const SolverSettings& settings);
nlohmann::ordered_json material_document(const Material& material);
nlohmann::ordered_json camera_document(const CameraSettings& camera);
nlohmann::ordered_json display_document(const DisplaySettings& display);

/// Sets the scene's file to `file` and updates its paths, so that they lead to the same files.
void move_scene(Scene& scene, const std::filesystem::path& file);

/// Puts on one line what fits there, and every list without objects, however long. Ends with a line break.
std::string text_of(const nlohmann::ordered_json& document);

}  // namespace fascia
