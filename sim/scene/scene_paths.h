// Where the files of a scene are, and how a scene says so.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// At the beginning of a path: below asset_folder() (base/data_folder.h), wherever the program is installed.
inline constexpr std::string_view kAssetPrefix = "assets:";

/// `path` of `scene` as a scene in `folder` (empty: the working folder) has it. One of a shipped file begins with
/// "assets:"; one in the same folder as before, and one that is absolute, stays; any other is relative where it leads
/// below `folder`, else absolute.
std::string path_from(const std::filesystem::path& folder, const Scene& scene, const std::string& path);

/// The path of the file that the one at `path` calls `name`: kidney.mtl of meshes/kidney.obj.
std::string path_beside(const std::string& path, const std::string& name);

/// Where a file was looked for.
struct Search {
  std::optional<std::filesystem::path> found;
  std::string looked;  // the places, for people; and what was there but is another file
};
/// At `path`, then, by its name, in the scene's folder, then, by the content that `scene` knows of it, there and among
/// shipped files. One that was found by its name and has another content than that is not taken.
Search search(const Scene& scene, const std::string& path);

/// Files that are found elsewhere than the scene's paths say: these lead there, with a note for each.
void find_moved_files(Scene& scene);

/// visit(path, key) of every file that the keys of a scene name; key: "bodies[0].mesh".
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
}

}  // namespace fascia
