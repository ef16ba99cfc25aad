#include "sim/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tiny_obj_loader.h>

#include "sim/error.h"
#include "sim/file.h"
#include "sim/polygon.h"

namespace fascia {
namespace {

using Library = std::function<std::string(const std::string&)>;

constexpr std::size_t kMostCorners = 255;  // of a polygon: the library counts them in a byte

/// Of `content` the lines that begin with one of these words, the others empty: what those say is passed over anyway, and the library
/// believes the counts of some (a tag "t") and allocates for them.
std::string lines_with(std::initializer_list<std::string_view> words, std::string_view content, const std::filesystem::path& path) {
  std::string out;
  out.reserve(content.size());
  for (std::size_t number = 1; !content.empty(); ++number) {
    const std::size_t end = std::min(content.find_first_of("\r\n"), content.size());
    const std::string_view line = content.substr(0, end);
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const std::string_view word = line.substr(begin, line.find_first_of(" \t", begin) - begin);
    if (std::find(words.begin(), words.end(), word) != words.end() && begin + word.size() < line.size()) out += line;
    if (word == "f") {
      std::size_t corners = 0;
      for (std::size_t at = begin + 1; (at = line.find_first_not_of(" \t", at)) != line.npos; ++corners)
        at = std::min(line.find_first_of(" \t", at), line.size());
      if (corners > kMostCorners)
        throw Error(path.string() + ":" + std::to_string(number), "a face has " + std::to_string(corners) + " corners",
                    "expected at most " + std::to_string(kMostCorners) + ": cut it into triangles");
    }
    const bool two = end + 1 < content.size() && content[end] == '\r' && content[end + 1] == '\n';
    if (end < content.size()) out += '\n';
    content.remove_prefix(std::min(end + (two ? 2 : 1), content.size()));
  }
  return out;
}

std::uint32_t packed(double r, double g, double b) {
  const auto byte = [](double share) { return static_cast<std::uint32_t>(std::lround(255 * std::clamp(std::isnan(share) ? 0.0 : share, 0.0, 1.0))); };
  return byte(r) | byte(g) << 8 | byte(b) << 16 | 0xff000000u;
}

/// Hands material libraries to the OBJ reader.
class LibraryReader : public tinyobj::MaterialReader {
 public:
  LibraryReader(const Library& read, const std::filesystem::path& path, std::vector<std::string>& notes)
      : read_(read), path_(path), notes_(notes) {}
  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials, std::map<std::string, int>* numbers,
                  std::string* warning, std::string* error) override {
    try {
      std::istringstream text(lines_with({"newmtl", "Kd"}, read_(name), path_));
      tinyobj::LoadMtl(numbers, materials, &text, warning, error);
    } catch (const Error& missing) {
      notes_.push_back(std::string(missing.what()) + ": drawn without its materials");
    }
    return true;  // or the library tries the next name of the line, and complains
  }

 private:
  const Library& read_;
  const std::filesystem::path& path_;
  std::vector<std::string>& notes_;
};

struct ObjContent {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
};

ObjContent parse(const std::filesystem::path& path, std::string_view content, const Library& read_library, std::vector<std::string>& notes) {
  std::istringstream text(read_library ? lines_with({"v", "f", "mtllib", "usemtl"}, content, path) : lines_with({"v", "f"}, content, path));
  LibraryReader libraries(read_library, path, notes);
  ObjContent obj;
  std::string warning, error;
  const bool read = tinyobj::LoadObj(&obj.attributes, &obj.shapes, &obj.materials, &warning, &error, &text,
                                     read_library ? &libraries : nullptr, false, false);
  if (!read) {
    if (const std::size_t end = error.find('\n'); end != std::string::npos) error.resize(end);
    throw Error(path.string(), error.empty() ? "cannot be understood" : error, "expected a Wavefront .obj surface");
  }
  return obj;
}

void read_positions(const std::filesystem::path& path, const ObjContent& obj, SurfaceMesh& mesh) {
  const auto& v = obj.attributes.vertices;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
    mesh.positions.emplace_back(v[i], v[i + 1], v[i + 2]);
    if (!mesh.positions.back().allFinite())
      throw Error(path.string(), "vertex " + std::to_string(i / 3 + 1) + " is not finite", "expected finite coordinates");
  }
}

void read_materials(const ObjContent& obj, SurfaceMesh& mesh) {
  for (const tinyobj::material_t& material : obj.materials)
    mesh.materials.push_back({material.name, packed(material.diffuse[0], material.diffuse[1], material.diffuse[2])});
}

/// The triangles of all faces, and of each the number of its material, -1 for none.
std::vector<int> read_faces(const std::filesystem::path& path, const ObjContent& obj, SurfaceMesh& mesh) {
  std::vector<int> material;
  std::vector<std::uint32_t> corners;
  for (const tinyobj::shape_t& shape : obj.shapes) {
    std::size_t next = 0;
    for (std::size_t face = 0; face < shape.mesh.num_face_vertices.size(); ++face) {
      corners.clear();
      for (const std::size_t end = next + shape.mesh.num_face_vertices[face]; next < end; ++next) {
        const int v = shape.mesh.indices[next].vertex_index;
        if (v < 0 || static_cast<std::size_t>(v) >= mesh.positions.size())
          throw Error(path.string(), "a face uses vertex " + std::to_string(v + 1),
                      "expected 1 to " + std::to_string(mesh.positions.size()));
        corners.push_back(static_cast<std::uint32_t>(v));
      }
      triangulate(mesh.positions, corners, mesh.triangles);
      material.resize(mesh.triangles.size(), shape.mesh.material_ids[face]);
    }
  }
  return material;
}

void add_colors(const ObjContent& obj, const std::vector<int>& material, SurfaceMesh& mesh) {
  for (const int number : material)
    if (number >= 0) ++mesh.materials[static_cast<std::size_t>(number)].triangles;
  const auto& rgb = obj.attributes.colors;
  mesh.vertex_colors = !rgb.empty() && rgb.size() == obj.attributes.vertices.size();
  const bool by_material = std::any_of(material.begin(), material.end(), [](int number) { return number >= 0; });
  if (!mesh.vertex_colors && !by_material) return;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      const std::size_t at = 3 * std::size_t{v};
      mesh.colors.push_back(mesh.vertex_colors ? packed(rgb[at], rgb[at + 1], rgb[at + 2])
                            : material[t] >= 0 ? mesh.materials[static_cast<std::size_t>(material[t])].color
                                               : 0);
    }
  }
}

}  // namespace

bool is_surface_file(const std::filesystem::path& path) { return lower_ending(path) == ".obj"; }

SurfaceMesh read_obj(const std::filesystem::path& path) {
  return read_obj_content(path, read_file(path), [&](const std::string& name) { return read_file(path.parent_path() / name); });
}

SurfaceMesh read_obj_content(const std::filesystem::path& path, std::string_view content, const Library& read_library) {
  SurfaceMesh mesh;
  const ObjContent obj = parse(path, content, read_library, mesh.notes);
  read_positions(path, obj, mesh);
  read_materials(obj, mesh);
  const std::vector<int> material = read_faces(path, obj, mesh);
  if (mesh.triangles.empty()) throw Error(path.string(), "has no faces", "expected a Wavefront .obj surface");
  add_colors(obj, material, mesh);
  return mesh;
}

}  // namespace fascia
