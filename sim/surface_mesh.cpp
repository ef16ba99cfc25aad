#include "sim/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tiny_obj_loader.h>

#include "sim/error.h"
#include "sim/file.h"

namespace fascia {
namespace {

/// The lines of vertices and faces, the others empty: what they say is passed over anyway, and the library believes the counts of some
/// (a tag "t") and allocates for them.
std::string vertices_and_faces(std::string_view content) {
  std::string out;
  while (!content.empty()) {
    const std::size_t end = std::min(content.find_first_of("\r\n"), content.size());
    const std::string_view line = content.substr(0, end);
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const bool wanted = begin + 1 < line.size() && (line[begin] == 'v' || line[begin] == 'f') &&
                        (line[begin + 1] == ' ' || line[begin + 1] == '\t');
    if (wanted) out += line;
    if (end < content.size()) out += content[end];
    content.remove_prefix(std::min(end + 1, content.size()));
  }
  return out;
}

}  // namespace

SurfaceMesh read_obj(const std::filesystem::path& path) {
  return read_obj_content(path, read_file(path));
}

SurfaceMesh read_obj_content(const std::filesystem::path& path, std::string_view content) {
  std::istringstream text(vertices_and_faces(content));
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  const bool read = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &text, nullptr, true);
  if (!read) {
    if (const std::size_t end = error.find('\n'); end != std::string::npos) error.resize(end);
    throw Error(path.string(), error.empty() ? "cannot be understood" : error, "expected a Wavefront .obj surface");
  }
  SurfaceMesh mesh;
  for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3) {
    mesh.positions.emplace_back(attributes.vertices[i], attributes.vertices[i + 1], attributes.vertices[i + 2]);
    if (!mesh.positions.back().allFinite())
      throw Error(path.string(), "vertex " + std::to_string(i / 3 + 1) + " is not finite", "expected finite coordinates");
  }
  for (const tinyobj::shape_t& shape : shapes) {
    const auto& indices = shape.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      Triangle triangle;
      for (int k = 0; k < 3; ++k) {
        const int v = indices[i + k].vertex_index;
        if (v < 0 || static_cast<std::size_t>(v) >= mesh.positions.size())
          throw Error(path.string(), "a face uses vertex " + std::to_string(v + 1),
                      "expected 1 to " + std::to_string(mesh.positions.size()));
        triangle[k] = static_cast<std::uint32_t>(v);
      }
      mesh.triangles.push_back(triangle);
    }
  }
  if (mesh.triangles.empty()) throw Error(path.string(), "has no faces", "expected a Wavefront .obj surface");
  return mesh;
}

}  // namespace fascia
