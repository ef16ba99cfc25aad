// The keys before the "=" of --set, and the values after it if they are few: for completion of command lines.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct SceneKey {
  std::string name;                 // "solver.method"; without "bodies.0." for body 0
  std::vector<std::string> values;  // empty: any
};

/// The keys of a scene with one body of one material as the writer of scenes outputs them, so that the list is
/// complete.
std::vector<SceneKey> scene_keys();

}  // namespace fascia
