#include "sim/model/file_reader.h"

#include <algorithm>

#include "base/file.h"
#include "sim/scene/scene_paths.h"

namespace fascia {
namespace fs = std::filesystem;

FileReader::File FileReader::read(const std::string& path, const std::string& key, const Progress& progress) {
  const std::string named = where() + ": " + key + ": ";
  File file{path, key, scene_.file / path, {}};
  if (scene_.carries(path)) {
    file.content = carried_content(*scene_.recorded(path), where());
  } else {
    const Search searched = search(scene_, path);
    if (!searched.found) throw Error(named + path, "no such file", "looked in " + searched.looked);
    file.place = *searched.found;
    file.content = blaming(file, [&] { return read_file(file.place, progress); });
    if (file.place != scene_.resolve(path))
      notes.push_back(named + path + ": no such file; read " + file.place.string());
  }
  remember(file);
  return file;
}

FileReader::File FileReader::find_beside(const File& file, const std::string& name) {
  File other{path_beside(file.path, name), file.key, file.place.parent_path() / name, {}};
  if (scene_.carries(other.path)) {
    other.place = scene_.file / other.path;
    other.content = carried_content(*scene_.recorded(other.path), where());
    return other;
  }
  if (std::error_code ec; !fs::exists(other.place, ec)) {
    const Search searched = scene_.carries(file.path) ? Search{} : search(scene_, other.path);
    if (!searched.found)
      throw Error(other.place.string(), "no such file", "expected beside " + file.place.filename().string());
    other.place = *searched.found;
  }
  other.content = read_file(other.place);
  return other;
}

void FileReader::remember(const File& file, const std::string& name) {
  ReadFile read{file.key, name, {file.path, file.content.size(), content_hash(file.content), nullptr}, file.place};
  if (const KnownFile* known = scene_.recorded(file.path)) {
    read.file.deflated = known->deflated;
    if (known->deflated) read.place.clear();
    if (known->size != read.file.size || known->hash != read.file.hash)
      notes.push_back(file.place.string() + ": has changed since " + where() + " was written");
  }
  if (std::none_of(files.begin(), files.end(), [&](const ReadFile& f) { return f.key == file.key && f.name == name; }))
    files.push_back(std::move(read));
}

ShapeFile FileReader::shape(const File& file) {
  const bool names_libraries = lower_ending(file.place) == ".obj";
  const auto read_beside = [&](const std::string& name) {
    const File other = find_beside(file, name);
    // Another file of a library's name is not part of the scene, and is not moved with the scene.
    if (!names_libraries || other.content.find("newmtl") != std::string::npos) remember(other, name);
    return other.content;
  };
  return blaming(file, [&] { return read_shape_content(file.place, file.content, read_beside); });
}

SurfaceMesh FileReader::surface(const File& file) {
  ShapeFile shape = this->shape(file);
  return blaming(file, [&] {
    if (!shape.surface) throw Error(file.place.string(), "holds tets", "expected a surface");
    return std::move(*shape.surface);
  });
}

}  // namespace fascia
