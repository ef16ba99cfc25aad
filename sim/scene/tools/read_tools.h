// Reads and writes the rigid things of a scene: keys "contact", "ground", "obstacles", "instruments".
#pragma once
#include <nlohmann/json.hpp>

#include "base/json/json_node.h"
#include "sim/scene/tools/scene_names.h"
#include "sim/scene/tools/scene_tools.h"

namespace fascia {

/// What the keys of tools may be.
namespace tool_limits {
inline constexpr double kFarthest = 1e6, kSmallest = 1e-9;  // [m]
inline constexpr double kLongest = 1e9, kShortest = 1e-9;   // [s]
}  // namespace tool_limits

/// `root`: the scene. `names` gets those of obstacles and instruments. Throws Error.
SceneTools read_tools(const Node& root, SceneNames& names);
/// Adds the keys to the document of the scene; none without tools and with default settings.
void write_tools(const SceneTools& tools, nlohmann::ordered_json& document);

}  // namespace fascia
