// Tetrahedral meshes as arrays: of a program's own, by formula, or from a file.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fascia/control.h"
#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  struct Mesh {
    std::vector<double> positions{};  // [vertex_count][3] at rest [m]
    std::vector<std::uint32_t>
        tets{};  // [tet_count][4] vertices; of either winding: simulations reorient those of negative volume
    std::vector<int> regions{};                 // [tet_count] numbers that materials are given by; empty: all 0
    std::map<int, std::string> region_names{};  // where a file has them
    std::map<std::string, std::vector<std::uint32_t>> groups{};  // vertex sets of a file by name, ascending

    std::size_t vertex_count() const { return positions.size() / 3; }
    std::size_t tet_count() const { return tets.size() / 4; }
  };

  /// Box [0, size] of nx * ny * nz cells, six tets each; size [m]. The vertex at cell corner (i, j, k) is (k * (ny + 1)
  /// + j) * (nx + 1) + i. Throws Error for cells below 1 or a size that is not positive.
  FASCIA_EXPORT Mesh make_box(int nx, int ny, int nz, const Vec3& size);

  /// Gmsh .msh, VTK .vtk and .vtu, TetGen .node/.ele, Medit .mesh; found by the content. Throws Error with file and
  /// line, Interrupted.
  FASCIA_EXPORT Mesh read_mesh(const std::string& path, const Control& control = {});

}  // namespace api
}  // namespace fascia
