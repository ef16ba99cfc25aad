#include "sim/scene/scene_paths.h"

#include <algorithm>

#include "base/data_folder.h"
#include "base/file.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

/// The absolute path with links in folders resolved; a link in the place of the file itself keeps its name.
fs::path whole(const fs::path& path) {
  std::error_code ec;
  const fs::path absolute = fs::absolute(path, ec);
  return fs::weakly_canonical(absolute.parent_path(), ec) / absolute.filename();
}

/// `path` relative to `folder` if it lies below; both are absolute.
std::optional<fs::path> below(const fs::path& folder, const fs::path& path) {
  const fs::path relative = path.lexically_relative(folder);
  if (folder.empty() || relative.empty() || *relative.begin() == "..") return std::nullopt;
  return relative;
}

fs::path whole_folder(const fs::path& folder) { return whole((folder.empty() ? "." : folder) / "").parent_path(); }

fs::path whole_assets() {
  const fs::path assets = asset_folder();
  return assets.empty() ? assets : whole_folder(assets);
}

std::string shown(const fs::path& folder) { return folder.empty() ? "." : folder.lexically_normal().string(); }

bool is_file(const fs::path& path) {
  std::error_code ec;
  return fs::exists(path, ec) && !fs::is_directory(path, ec);
}

/// Finds a file with this content and extension. Finds nothing in a folder that cannot be listed.
template <class Iterator>
std::optional<fs::path> find_content(Iterator entry, const KnownFile& file) {
  std::error_code ec;
  for (; entry != Iterator(); entry.increment(ec)) {
    if (lower_ending(entry->path()) == lower_ending(file.path) && has_content(entry->path(), file))
      return entry->path();
    if (ec) break;
  }
  return std::nullopt;
}

std::optional<fs::path> find_by_content(const fs::path& folder, const fs::path& assets, const KnownFile& file) {
  std::error_code ec;
  if (auto found = find_content(fs::directory_iterator(shown(folder), ec), file)) return found;
  return assets.empty() ? std::nullopt : find_content(fs::recursive_directory_iterator(assets, ec), file);
}

/// Shipped scenes, and copies of them, have their meshes at ../meshes/NAME or .../assets/meshes/NAME.
fs::path shipped_place(const fs::path& assets, const fs::path& path) {
  return !assets.empty() && path.parent_path().filename() == "meshes" ? assets / "meshes" / path.filename()
                                                                      : fs::path();
}

}  // namespace

std::string path_from(const fs::path& folder, const Scene& scene, const std::string& path) {
  if (scene.carries(path) || path.starts_with(kAssetPrefix)) return path;
  const fs::path target = whole(scene.resolve(path)), base = whole_folder(folder), assets = whole_assets();
  const bool same_folder = whole_folder(scene.file.parent_path()) == base,
             in_assets = !assets.empty() && (base == assets || below(assets, base));
  if (const auto shipped = below(assets, target); shipped && !(same_folder && in_assets))
    return std::string(kAssetPrefix) + shipped->string();
  if (same_folder || fs::path(path).is_absolute()) return path;
  return below(base, target).value_or(target).string();
}

std::string path_beside(const std::string& path, const std::string& name) {
  if (fs::path(name).is_absolute()) return name;
  const std::size_t slash = path.rfind('/');
  const std::size_t folder = slash != std::string::npos       ? slash + 1
                             : path.starts_with(kAssetPrefix) ? kAssetPrefix.size()
                                                              : 0;
  return path.substr(0, folder) + name;
}

Search search(const Scene& scene, const std::string& path) {
  const fs::path written = scene.resolve(path), folder = scene.file.parent_path(), assets = asset_folder();
  std::error_code ec;
  if (fs::status(written, ec).type() != fs::file_type::not_found) return {written, {}};  // the read reports the error
  Search result{{}, shown(written.parent_path())};
  if (written.filename().empty()) return result;
  const KnownFile* file = scene.recorded(path);
  const fs::path beside = folder / written.filename(), shipped = shipped_place(assets, written);
  for (const fs::path& place : {beside, shipped}) {
    if (place.empty() || !is_file(place)) continue;
    if (!file || has_content(place, *file)) return {place, {}};
    result.looked += ", " + shown(place.parent_path()) + " (whose " + place.filename().string() + " is another file)";
  }
  if (file) result.found = find_by_content(folder, assets, *file);
  if (!is_file(beside) && shown(folder) != result.looked) result.looked += ", " + shown(folder);
  if (!assets.empty() && (file || !shipped.empty()) && !is_file(shipped)) result.looked += ", " + assets.string();
  return result;
}

void find_moved_files(Scene& scene) {
  for_each_path(scene, [&](std::string& path, const std::string& key) {
    if (scene.carries(path)) return;
    const Search searched = search(scene, path);
    if (!searched.found || *searched.found == scene.resolve(path)) return;
    const std::string before = path;
    Scene there;
    there.file = *searched.found;
    path = path_from(scene.file.parent_path(), there, searched.found->filename().string());
    std::vector<KnownFile> known;  // also under the new paths
    for (KnownFile file : scene.files) {
      const std::string name = fs::path(file.path).filename().string();
      if (file.path != before && file.path != path_beside(before, name)) continue;
      file.path = file.path == before ? path : path_beside(path, name);
      known.push_back(std::move(file));
    }
    scene.files.insert(scene.files.end(), known.begin(), known.end());
    scene.notes.push_back(scene.file.string() + ": " + key + ": " + before + ": no such file; read " +
                          searched.found->string());
  });
}

}  // namespace fascia
