// Finds the files of a scene, and writes their paths relative to a scene.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// Prefix of a path: below asset_folder() (base/data_folder.h), for any place of installation.
inline constexpr std::string_view kAssetPrefix = "assets:";

/// The form of `path` of `scene` in a scene in `folder` (empty: the working folder). The path of a shipped file begins
/// with "assets:"; an absolute path, or one in an unchanged folder, is kept; any other is relative if it leads below
/// `folder`, else absolute.
std::string path_from(const std::filesystem::path& folder, const Scene& scene, const std::string& path);

/// The path of the file that is called `name` in the file at `path`: kidney.mtl of meshes/kidney.obj.
std::string path_beside(const std::string& path, const std::string& name);

/// The result of a search for a file.
struct Search {
  std::optional<std::filesystem::path> found;
  std::string looked;  // the places searched, for messages, and different files found there
};
/// Searches at `path`, then by name in the scene's folder, then by the content known to `scene`, there and among
/// shipped files. A file found by its name is not taken if its content differs from the known one.
Search search(const Scene& scene, const std::string& path);

/// Updates the scene's paths to files that were found at other places, with a note for each.
void find_moved_files(Scene& scene);

/// visit(path, key) for every file that the keys of a scene name; key: "bodies[0].mesh".
template <class S, class Visit>
void for_each_path(S& scene, const Visit& visit) {
  using Text = std::conditional_t<std::is_const_v<S>, const std::string, std::string>;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    auto& body = scene.bodies[b];
    const std::string key = "bodies[" + std::to_string(b) + "].";
    visit(body.mesh, key + "mesh");
    if (!body.surface.empty()) visit(body.surface, key + "surface");
    for (std::size_t m = 0; m < body.prescribed.size(); ++m)
      if (Text& targets = body.prescribed[m].targets; !targets.empty())
        visit(targets, key + "prescribed[" + std::to_string(m) + "].targets");
    if (Text* velocity = std::get_if<std::string>(&body.initial_velocity)) visit(*velocity, key + "initial_velocity");
  }
  for_each_shape(scene.tools, [&](auto& shape, const std::string& key) {
    if (auto* mesh = std::get_if<MeshShape>(&shape)) visit(mesh->file, key + ".mesh.file");
  });
}

}  // namespace fascia
