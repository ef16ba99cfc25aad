// What may stand before the "=" of --set, and after it where the choice is small: for completion of command lines.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct SceneKey {
  std::string name;                 // "solver.method", of body 0 without "bodies.0."
  std::vector<std::string> values;  // empty: any
};

/// Of a scene with one body of one material, as scenes are written; no key can be forgotten here.
std::vector<SceneKey> scene_keys();

}  // namespace fascia
