// Reads a JSON document strictly to a Scene; scene files, --set, meshes on their own and replays all use this reader.
#pragma once
#include <nlohmann/json.hpp>

#include "base/json/json_node.h"
#include "sim/scene/scene.h"

namespace fascia {

// Bounds of the values in scenes.
inline constexpr double kFarthestLook = 1e9;    // [m] of cameras and planes
inline constexpr double kFarthestTissue = 1e6;  // [m] for everything that moves: float32 resolves 0.06 m there
inline constexpr double kLongestTime = 1e9;     // [s]

/// Reads everything in the scene except `file`. Throws Error, as do the readers of its parts.
Scene read_scene(const Node& root);
SolverSettings read_solver(const Node& node);
Body read_body(const Node& node);
ScriptedGrab read_grab(const Node& node);
Selection read_selection(const Node& node);
Material read_material(const Node& node);
CameraSettings read_camera(const Node& node);
DisplaySettings read_display(const Node& node);
std::vector<KnownFile> read_files(const Node& node);
std::uint64_t read_hash(const Node& node);  // hash_text

}  // namespace fascia
