// A scene together with its files: known data of them, or all of their contents, so that the scene opens in an empty
// folder.
#pragma once
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// `scene` with known data of its files; files that it already carries are kept. `read`: Model::files of the model that
/// was built from it.
Scene with_known_files(Scene scene, std::vector<ReadFile> read);

/// `scene` with the contents of all its files, under their names without folders. Contents not yet in memory are read
/// again and kept in `read`. Throws Error if a file is missing, has changed or is too large to be carried.
Scene self_contained(Scene scene, std::vector<ReadFile>& read);

/// As self_contained(); if that fails, or the files exceed `most` bytes together, as with_known_files().
Scene self_contained_if_possible(Scene scene, std::vector<ReadFile>& read, std::uint64_t most = kMostCarried);

}  // namespace fascia
