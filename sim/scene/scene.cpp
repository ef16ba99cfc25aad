#include "sim/scene/scene.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/data_folder.h"
#include "base/error.h"
#include "base/file.h"
#include "base/json/json_document.h"
#include "base/rotation.h"
#include "sim/material/tissues.h"
#include "sim/scene/scene_overrides.h"
#include "sim/scene/scene_paths.h"
#include "sim/scene/scene_read.h"

namespace fascia {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors start text files with it

/// The first character that is no space and no byte order mark, without reading a whole large mesh.
char first_character(const std::filesystem::path& path) {
  std::error_code ec;
  std::ifstream file;
  std::istringstream kept;
  const bool is_file = std::filesystem::is_regular_file(path, ec);
  if (is_file)
    file.open(path, std::ios::binary);
  else
    kept.str(read_file(path));  // reading a pipe consumes its data
  std::istream& in = is_file ? static_cast<std::istream&>(file) : kept;
  for (char c = 0; in >> c;)
    if (kByteOrderMark.find(c) == kByteOrderMark.npos) return c;
  read_file(path);  // throws the error of an unreadable file
  throw Error(path.string(), "is empty", "expected a scene (JSON) or a tet mesh");
}

bool is_scene(const std::filesystem::path& path) {
  const char first = first_character(path);
  return first == '{' || path.extension() == ".json";
}

Scene read_document(nlohmann::json& document, const std::filesystem::path& path,
                    const std::vector<std::string>& overrides) {
  DocumentOrigin origin{path.string(), {}};
  apply_overrides(document, overrides, origin);
  Scene scene = read_scene(Node(document, "", origin));
  scene.file = path;
  return scene;
}

/// `body`: of a mesh on its own, as JSON with the overrides applied.
Unsettled left_open(const nlohmann::json& body, const std::vector<std::string>& overrides) {
  const auto material = body.contains("materials") ? body["materials"].value("default", nlohmann::json::object())
                                                   : nlohmann::json::object();
  Unsettled open;
  open.unit = !body.contains("unit");
  open.up = !body.contains("up");
  open.supports = !body.contains("fixed") && !body.contains("prescribed");
  open.stiffness = !material.contains("young_modulus") && !material.contains("preset");
  open.law = !material.contains("model");
  open.overrides = overrides;
  return open;
}

}  // namespace

std::filesystem::path Scene::resolve(const std::string& path) const {
  if (const auto assets = asset_folder(); path.starts_with(kAssetPrefix) && !assets.empty())
    return assets / path.substr(kAssetPrefix.size());
  return file.parent_path() / path;  // an absolute path replaces the folder
}

const KnownFile* Scene::recorded(const std::string& path) const {
  const auto found = std::find_if(files.begin(), files.end(), [&](const KnownFile& f) { return f.path == path; });
  return found == files.end() ? nullptr : &*found;
}

bool Scene::carries(const std::string& path) const {
  const KnownFile* found = recorded(path);
  return found && found->deflated;
}

Scene open_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  if (is_scene(path)) {
    Scene scene = read_scene_content(path, read_file(path), overrides);
    find_moved_files(scene);
    return scene;
  }
  nlohmann::json document;
  document["fascia_scene"] = 1;
  document["title"] = path.filename().string();
  document["bodies"][0]["mesh"] = path.filename().string();
  Scene scene = read_document(document, path, overrides);
  scene.unsettled = left_open(document["bodies"][0], overrides);
  return scene;
}

Scene read_scene_content(const std::filesystem::path& path, std::string_view content,
                         const std::vector<std::string>& overrides) {
  nlohmann::json document = parse_json(content, path.string());
  return read_document(document, path, overrides);
}

Eigen::Affine3d placement(const Body& body) {
  const Transform& transform = body.transform;
  return Eigen::Translation3d(transform.translate) * Eigen::Affine3d(rotation_of(transform.rotate_deg)) *
         Eigen::Scaling(transform.scale * meters(body.unit)) * Eigen::Affine3d(turned_up(body.up));
}

}  // namespace fascia
