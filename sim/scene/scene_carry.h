// A scene together with its files: what is known of them, or all of them in it, so that it opens from an empty folder.
#pragma once
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// `scene` with what is known of its files; those that it carried it still does. `read`: Model::files of the model that
/// was built from it.
Scene with_known_files(Scene scene, std::vector<ReadFile> read);

/// `scene` with all of its files in it, by their names without folders. What is not in memory yet is read again and
/// kept in `read`. Throws Error where a file is gone, has changed or is too large to be carried.
Scene self_contained(Scene scene, std::vector<ReadFile>& read);

/// As self_contained(), or where that cannot be, or the files have more than `most` bytes together, as
/// with_known_files().
Scene self_contained_if_possible(Scene scene, std::vector<ReadFile>& read, std::uint64_t most = kMostCarried);

}  // namespace fascia
