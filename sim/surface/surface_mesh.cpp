#include "sim/surface/surface_mesh.h"

#include <tiny_obj_loader.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "sim/mesh/io/scanner.h"
#include "sim/mesh/polygon.h"
#include "sim/surface/obj_lines.h"
#include "sim/surface/obj_materials.h"

namespace fascia {
namespace {

constexpr std::size_t kMostCorners = 255;  // of a polygon: the library stores the number in a byte

[[noreturn]] void fail_at(const std::filesystem::path& path, std::size_t line, const std::string& what,
                          const std::string& expected) {
  std::string where = path.string();
  if (line > 0) where.append(":").append(std::to_string(line));
  throw Error(where, what, expected);
}

/// The library takes coordinates that it cannot read, and those that are missing, for 0.
void require_coordinates(const std::filesystem::path& path, const ObjLine& line) {
  std::string_view rest = line.rest;
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [stop, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (stop != digits.data() + digits.size() || status == std::errc::invalid_argument || !std::isfinite(value))
      fail_at(path, line.number, "a vertex has " + (word.empty() ? "too few numbers" : in_quotes(word)),
              "expected three finite coordinates");
    rest.remove_prefix(word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  }
}

/// The vertices and faces for the library, with materials by number. Other lines are dropped: they are skipped in any
/// case, and the library trusts the counts of some (a tag "t") for allocations.
std::string prepared(const std::filesystem::path& path, std::string_view content, const ObjMaterials::Library& library,
                     ObjMaterials& materials) {
  std::string out = "mtllib all\n";
  out.reserve(content.size());
  for_each_obj_line(content, [&](const ObjLine& line) {
    if (line.rest.empty()) return;
    if (line.word == "f") {
      std::size_t corners = 0;
      for (std::size_t at = 0; (at = line.rest.find_first_not_of(" \t", at)) != line.rest.npos; ++corners)
        at = std::min(line.rest.find_first_of(" \t", at), line.rest.size());
      if (corners > kMostCorners)
        fail_at(path, line.number, "a face has " + std::to_string(corners) + " corners",
                "expected at most " + std::to_string(kMostCorners) + ": cut it into triangles");
    } else if (line.word == "mtllib") {
      if (library) materials.read_libraries(std::string(line.rest), library);
      return;
    } else if (line.word == "usemtl") {
      if (library) out.append("usemtl ").append(std::to_string(materials.number(line.rest))) += '\n';
      return;
    } else if (line.word == "v") {
      require_coordinates(path, line);
    } else {
      return;
    }
    out.append(line.word).append(" ").append(line.rest) += '\n';
  });
  return out;
}

/// Gives the library the numbers of the materials.
class Numbers : public tinyobj::MaterialReader {
 public:
  explicit Numbers(std::size_t count) : count_(count) {}
  bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>* numbers,
                  std::string*, std::string*) override {
    for (std::size_t m = 0; m < count_; ++m) (*numbers)[std::to_string(m)] = static_cast<int>(m);
    return true;
  }

 private:
  std::size_t count_;
};

struct ObjContent {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
};

ObjContent parse(const std::filesystem::path& path, const std::string& prepared, std::size_t materials) {
  std::istringstream text(prepared);
  Numbers numbers(materials);
  ObjContent obj;
  std::vector<tinyobj::material_t> none;
  std::string warning, error;
  if (!tinyobj::LoadObj(&obj.attributes, &obj.shapes, &none, &warning, &error, &text, &numbers, false, false)) {
    if (const std::size_t end = error.find('\n'); end != std::string::npos) error.resize(end);
    throw Error(path.string(), error.empty() ? "cannot be understood" : error, "expected a Wavefront .obj surface");
  }
  return obj;
}

/// The number of the first line that begins with `word` and for which `wrong(rest)` holds; 0 if there is none.
template <typename Wrong>
std::size_t line_of(std::string_view content, std::string_view word, const Wrong& wrong) {
  std::size_t found = 0;
  for_each_obj_line(content, [&](const ObjLine& line) {
    if (found == 0 && line.word == word && !line.rest.empty() && wrong(line.rest)) found = line.number;
  });
  return found;
}

void read_positions(const std::filesystem::path& path, std::string_view content, const ObjContent& obj,
                    SurfaceMesh& mesh) {
  const auto& v = obj.attributes.vertices;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
    mesh.positions.emplace_back(v[i], v[i + 1], v[i + 2]);
    if (mesh.positions.back().allFinite()) continue;
    std::size_t number = i / 3 + 1;
    fail_at(path, line_of(content, "v", [&](std::string_view) { return --number == 0; }),
            "vertex " + std::to_string(i / 3 + 1) + " is not finite in float32", "expected finite coordinates");
  }
}

bool names(std::string_view face, int vertex) {
  std::istringstream corners{std::string(face)};
  for (std::string corner; corners >> corner;)
    if (std::atoi(corner.c_str()) == vertex) return true;
  return false;
}

/// The triangles of all faces, and the number of each triangle's material, -1 for none.
std::vector<int> read_faces(const std::filesystem::path& path, std::string_view content, const ObjContent& obj,
                            SurfaceMesh& mesh) {
  std::vector<int> material;
  std::vector<std::uint32_t> corners;
  for (const tinyobj::shape_t& shape : obj.shapes) {
    std::size_t next = 0;
    for (std::size_t face = 0; face < shape.mesh.num_face_vertices.size(); ++face) {
      corners.clear();
      for (const std::size_t end = next + shape.mesh.num_face_vertices[face]; next < end; ++next) {
        const int v = shape.mesh.indices[next].vertex_index;
        if (v < 0 || static_cast<std::size_t>(v) >= mesh.positions.size())
          fail_at(
              path,
              line_of(content, "f", [&](std::string_view corners_of_line) { return names(corners_of_line, v + 1); }),
              "a face uses vertex " + std::to_string(v + 1), "expected 1 to " + std::to_string(mesh.positions.size()));
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
  const bool by_material = std::any_of(material.begin(), material.end(), [&](int number) {
    return number >= 0 && mesh.materials[static_cast<std::size_t>(number)].color != 0;
  });
  if (!mesh.vertex_colors && !by_material) return;
  const bool bytes = mesh.vertex_colors && std::any_of(rgb.begin(), rgb.end(), [](auto share) { return share > 1; });
  if (bytes) mesh.notes.emplace_back("colors of vertices above 1: read as 0 to 255");
  const double full = bytes ? 255 : 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      const std::size_t at = 3 * std::size_t{v};
      mesh.colors.push_back(mesh.vertex_colors ? packed_color(rgb[at] / full, rgb[at + 1] / full, rgb[at + 2] / full)
                            : material[t] >= 0 ? mesh.materials[static_cast<std::size_t>(material[t])].color
                                               : 0);
    }
  }
}

}  // namespace

SurfaceMesh read_obj(const std::filesystem::path& path, const Progress& progress) {
  return read_obj_content(path, read_file(path, progress),
                          [&](const std::string& name) { return read_file(path.parent_path() / name); });
}

SurfaceMesh read_obj_content(const std::filesystem::path& path, std::string_view content,
                             const ObjMaterials::Library& read_library) {
  SurfaceMesh mesh;
  mesh.format = "Wavefront OBJ";
  ObjMaterials materials;
  const std::string text = prepared(path, content, read_library, materials);
  mesh.materials = materials.take(mesh.notes);
  const ObjContent obj = parse(path, text, mesh.materials.size());
  read_positions(path, content, obj, mesh);
  const std::vector<int> material = read_faces(path, content, obj, mesh);
  if (mesh.triangles.empty()) throw Error(path.string(), "has no faces", "expected a Wavefront .obj surface");
  add_colors(obj, material, mesh);
  return mesh;
}

Eigen::AlignedBox3d box_of(const SurfaceMesh& surface) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) box.extend(surface.positions[v]);
  return box;
}

}  // namespace fascia
