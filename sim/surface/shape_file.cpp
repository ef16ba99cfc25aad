#include "sim/surface/shape_file.h"

#include <new>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/polygon.h"

namespace fascia {
namespace {

SurfaceMesh surface_of(MeshFile file) {
  SurfaceMesh surface;
  surface.format = file.format;
  std::vector<std::uint32_t> corners;
  std::size_t begin = 0;
  const auto at = [&](std::size_t corner) { return file.faces.corners.begin() + static_cast<std::ptrdiff_t>(corner); };
  for (const std::size_t end : file.faces.ends) {
    corners.assign(at(begin), at(end));
    triangulate(file.mesh.positions, corners, surface.triangles);
    begin = end;
  }
  if (!file.vertex_colors.empty()) {
    surface.vertex_colors = true;
    for (const Triangle& triangle : surface.triangles)
      for (const std::uint32_t v : triangle) surface.colors.push_back(file.vertex_colors[v]);
  }
  surface.positions = std::move(file.mesh.positions);
  surface.notes = std::move(file.notes);
  if (!file.mesh.groups.empty()) {
    std::string names;
    for (const auto& [name, vertices] : file.mesh.groups) names += (names.empty() ? "" : ", ") + name;
    surface.notes.push_back("groups of a surface are not those of its tets: left out " + names);
  }
  return surface;
}

}  // namespace

ShapeFile read_shape_content(const std::filesystem::path& path, std::string_view content,
                             const std::function<std::string(const std::string&)>& read_beside) {
  if (lower_ending(path) == ".obj") return {{}, read_obj_content(path, content, read_beside)};
  try {
    MeshFile file = read_mesh_content(path, content, read_beside);
    if (file.is_surface()) return {{}, surface_of(std::move(file))};
    return {std::move(file), {}};
  } catch (const std::bad_alloc&) {
    throw Error(path.string(), "needs more memory than there is", "expected a smaller mesh");
  }
}

ShapeFile read_shape(const std::filesystem::path& path, const Progress& progress) {
  return read_shape_content(path, read_file(path, progress),
                            [&](const std::string& name) { return read_file(path.parent_path() / name); });
}

}  // namespace fascia
