// Parts of a scene as JSON documents, and a document as a text that people can read and edit.
#pragma once
#include <nlohmann/json.hpp>

#include "sim/scene/scene.h"

namespace fascia {

/// With paths as seen from `folder` (sim/scene/scene_paths.h). Without what is known of files.
nlohmann::ordered_json scene_document(const Scene& scene, const std::filesystem::path& folder);
/// And with it.
nlohmann::ordered_json complete_document(const Scene& scene, const std::filesystem::path& folder);
nlohmann::ordered_json solver_document(const SolverSettings& settings);
nlohmann::ordered_json material_document(const Material& material);
nlohmann::ordered_json camera_document(const CameraSettings& camera);
nlohmann::ordered_json display_document(const DisplaySettings& display);
nlohmann::ordered_json vector_document(const Eigen::Vector3d& v);

/// The scene's file is `file` from now on, and its paths lead where they led.
void move_scene(Scene& scene, const std::filesystem::path& file);

/// What fits stands on one line, and so does a list without objects, however long. Ends with a line break.
std::string text_of(const nlohmann::ordered_json& document);

}  // namespace fascia
