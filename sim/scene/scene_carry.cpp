#include "sim/scene/scene_carry.h"

#include <algorithm>
#include <functional>
#include <map>

#include "base/deflate.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene_paths.h"

namespace fascia {
namespace {

using Rename = std::function<std::string(const std::string& path)>;

void carry(ReadFile& read) {
  if (read.file.deflated) return;
  const std::string place = read.place.string();
  if (read.file.size > kMostCarried)
    throw Error(place, "has " + std::to_string(read.file.size) + " bytes",
                "expected at most " + std::to_string(kMostCarried) + " of a file that a scene carries");
  const std::string content = read_file(read.place);
  if (content.size() != read.file.size || content_hash(content) != read.file.hash)
    throw Error(place, "has changed since it was opened", "open the scene again, or save it without its mesh");
  read.file.deflated = std::make_shared<const std::string>(deflated(content));
}

/// `scene` with every file of `read` once, under the path that `rename` gives it, which also replaces the path in the
/// scene.
Scene with_files(Scene scene, const std::vector<ReadFile>& read, const Rename& rename) {
  std::vector<KnownFile> files;
  for_each_path(scene, [&](std::string& path, const std::string& key) {
    const std::string renamed = rename(path);
    for (const ReadFile& r : read) {
      if (r.key != key) continue;
      KnownFile file = r.file;
      file.path = r.name.empty() ? renamed : path_beside(renamed, r.name);
      const bool known =
          std::any_of(files.begin(), files.end(), [&](const KnownFile& f) { return f.path == file.path; });
      if (!known) files.push_back(std::move(file));
    }
    path = renamed;
  });
  scene.files = std::move(files);
  return scene;
}

/// Names without folders. If there are several folders, the files get numbers, since they may have the same names.
Rename short_names(const Scene& scene) {
  std::map<std::string, std::string> folders;
  for_each_path(scene,
                [&](const std::string& path, const std::string&) { folders.emplace(path_beside(path, ""), ""); });
  if (std::size_t number = 0; folders.size() > 1)
    for (auto& [folder, name] : folders) name = std::to_string(++number) + "/";
  return [folders = std::move(folders)](const std::string& path) {
    const std::string folder = path_beside(path, "");
    return folders.at(folder) + path.substr(folder.size());
  };
}

}  // namespace

Scene with_known_files(Scene scene, std::vector<ReadFile> read) {
  for (ReadFile& r : read)
    if (!r.place.empty()) r.file.deflated.reset();  // its data may be in memory for another scene
  return with_files(std::move(scene), read, [](const std::string& path) { return path; });
}

Scene self_contained(Scene scene, std::vector<ReadFile>& read) {
  std::for_each(read.begin(), read.end(), carry);
  const Rename rename = short_names(scene);
  return with_files(std::move(scene), read, rename);
}

Scene self_contained_if_possible(Scene scene, std::vector<ReadFile>& read, std::uint64_t most) {
  std::uint64_t bytes = 0;
  for (const ReadFile& r : read) bytes += r.file.deflated ? 0 : r.file.size;
  if (bytes > most) return with_known_files(std::move(scene), read);
  try {
    return self_contained(scene, read);
  } catch (const Error&) {
    return with_known_files(std::move(scene), read);
  }
}

}  // namespace fascia
