// A detailed surface (.obj) drawn instead of the boundary of a body's tets.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "sim/tet_mesh.h"

namespace fascia {

struct SurfaceMesh {
  std::vector<Eigen::Vector3d> positions;  // [n] [m]
  std::vector<Triangle> triangles;         // polygons of the file are cut into triangles
};

/// Wavefront .obj: positions and faces; materials, normals and texture coordinates are passed over. Throws Error.
SurfaceMesh read_obj(const std::filesystem::path& path);
/// As read_obj of a file with this content.
SurfaceMesh read_obj_content(const std::filesystem::path& path, std::string_view content);

}  // namespace fascia
