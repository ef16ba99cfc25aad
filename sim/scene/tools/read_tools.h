// Reads and writes the rigid things of a scene: keys "contact", "ground", "obstacles", "instruments".
#pragma once
#include <nlohmann/json.hpp>

#include "base/json/json_node.h"
#include "sim/scene/tools/scene_tools.h"

namespace fascia {

/// `root`: the scene. Throws Error.
SceneTools read_tools(const Node& root);
/// Adds the keys to the document of the scene; none without tools and with default settings.
void write_tools(const SceneTools& tools, nlohmann::ordered_json& document);

}  // namespace fascia
