// --set KEY=VALUE: changes to a scene's JSON document before it is read, so that one strict reader checks everything.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/json/json_node.h"

namespace fascia {

/// "bodies[0].mesh", "bodies.0.mesh" and "mesh" to {"bodies", "0", "mesh"}; empty if any segment is empty.
std::vector<std::string> segments_of(const std::string& key);

/// KEY is a dotted path ("bodies.0.materials.2.young_modulus", "gravity.1"; "bodies[0].mesh", as errors print it, is
/// accepted too). A KEY that starts with a key of bodies (materials, fixed, transform...) means body 0. VALUE is JSON,
/// or else a text. Missing objects, list elements at the end, and vectors (from their defaults) are created. A
/// material's preset removes the numbers of the file that it replaces. `origin` receives the paths that each override
/// changed. Throws Error for a text without '=', for a KEY that does not start with a key of a scene or body, and for a
/// path that leads into a number or past a list.
void apply_overrides(nlohmann::json& document, const std::vector<std::string>& overrides, DocumentOrigin& origin);

}  // namespace fascia
