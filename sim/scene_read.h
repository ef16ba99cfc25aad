// A JSON document to a Scene, strictly; the one reader behind scene files, --set and meshes opened alone.
#pragma once
#include <nlohmann/json.hpp>

#include "sim/scene.h"
#include "sim/scene_node.h"

namespace fascia {

/// All of the scene but `file`. Throws Error.
Scene read_scene(const nlohmann::json& document, const DocumentOrigin& origin);

Body read_body(const Node& node);

}  // namespace fascia
