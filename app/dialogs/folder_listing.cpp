#include "app/dialogs/folder_listing.h"

#include <algorithm>
#include <cctype>

#include "base/file.h"
#include "sim/mesh/io/mesh_formats.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

const std::vector<FileKind>& openable_kinds() {
  static const std::vector<FileKind> kinds = [] {
    FileKind all{"All that fascia opens", {}}, scenes{"Scenes", {".json"}}, meshes{"Meshes", tet_endings()},
        surfaces{"Surfaces", surface_endings()}, replays{"Replays", {".fascia"}}, curves{"Measured curves", {".csv"}};
    std::erase(meshes.endings, ".ele");  // of TetGen's pairs the .node file is listed
    for (const FileKind* kind : {&scenes, &replays, &meshes, &surfaces, &curves})
      all.endings.insert(all.endings.end(), kind->endings.begin(), kind->endings.end());
    return std::vector<FileKind>{all, scenes, meshes, surfaces, replays, curves};
  }();
  return kinds;
}

std::vector<FolderEntry> list_folder(const fs::path& folder, const FileKind& kind, const std::string& part) {
  std::vector<FolderEntry> entries;
  const std::string wanted = lower(part);
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string name = it->path().filename().string();
    std::error_code unreadable;
    const bool is_folder = it->is_directory(unreadable);
    const bool known =
        std::find(kind.endings.begin(), kind.endings.end(), lower_ending(it->path())) != kind.endings.end();
    if (name.front() == '.' || !(is_folder || known) || lower(name).find(wanted) == std::string::npos) continue;
    entries.push_back({it->path(), is_folder});
  }
  std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    const std::string left = lower(a.path.filename().string()), right = lower(b.path.filename().string());
    return left != right ? left < right : a.path < b.path;
  });
  return entries;
}

}  // namespace fascia
