// A surface: drawn instead of the boundary of a body's tets, or filled with tets. Read here from Wavefront .obj files,
// by sim/mesh/io from others.
#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct SurfaceMaterial {
  std::string name;
  std::uint32_t color;        // as SurfaceMesh::colors; 0 if its library is missing or gives no color
  std::size_t triangles = 0;  // that have it
};

struct SurfaceMesh {
  std::vector<Eigen::Vector3d> positions;  // [n] [m]
  std::vector<Triangle> triangles;         // of all shapes; polygons of the file are divided into triangles
  /// [3 * triangle_count] sRGB of the triangles' corners, 0xAABBGGRR, AA = ff, or 0 where the file gives none: the
  /// colors of the vertices if all of them have one, else the diffuse colors of the materials. Empty if the file gives
  /// no color at all.
  std::vector<std::uint32_t> colors;
  std::vector<SurfaceMaterial> materials;
  bool vertex_colors = false;
  bool closed = false;             // known to have no open edges (surface_repair.h)
  std::string format;              // as displayed: "STL binary"
  std::vector<std::string> notes;  // about skipped content, one sentence each
};

/// Of the vertices of its triangles.
Eigen::AlignedBox3d box_of(const SurfaceMesh& surface);

/// Wavefront .obj with its material libraries; normals and texture coordinates are skipped. Throws Error.
SurfaceMesh read_obj(const std::filesystem::path& path, const Progress& progress = {});
/// As read_obj of a file with this content. `read_library` returns the content of a material library by its name; an
/// Error that it throws becomes a note.
SurfaceMesh read_obj_content(const std::filesystem::path& path, std::string_view content,
                             const std::function<std::string(const std::string&)>& read_library = {});

}  // namespace fascia
