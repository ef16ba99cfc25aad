// What a mesh file holds: tets, or a surface that is filled with tets or drawn over them.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "sim/mesh/io/mesh_io.h"
#include "sim/surface/surface_mesh.h"

namespace fascia {

struct ShapeFile {
  MeshFile tets;                       // empty beside a surface
  std::optional<SurfaceMesh> surface;  // of a file without tets
};

/// `read_beside` returns the content of a file that the file names, by its name: a material library, the other file of
/// a TetGen mesh. Throws Error.
ShapeFile read_shape_content(const std::filesystem::path& path, std::string_view content,
                             const std::function<std::string(const std::string&)>& read_beside);
ShapeFile read_shape(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace fascia
