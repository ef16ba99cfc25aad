// Tetrahedral meshes as arrays: from a program, from a formula or from a file.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fascia/control.h"
#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// A tetrahedral mesh. Calls that receive a mesh check it and throw Error for arrays of wrong size, indices out of
  /// range and positions that are not finite.
  struct Mesh {
    /// [vertex_count][3] The positions at rest [m].
    std::vector<double> positions{};
    /// [tet_count][4] The vertices of each tet, in either winding. Simulations reorient tets of negative volume.
    std::vector<std::uint32_t> tets{};
    /// [tet_count] The region of each tet, by which Body::region_materials selects materials. If it is empty, all
    /// regions are 0.
    std::vector<int> regions{};
    /// The names of regions, if a file has them.
    std::map<int, std::string> region_names{};
    /// The named vertex sets of a file. Each set is ascending.
    std::map<std::string, std::vector<std::uint32_t>> groups{};

    /// Returns the number of vertices.
    std::size_t vertex_count() const { return positions.size() / 3; }
    /// Returns the number of tets.
    std::size_t tet_count() const { return tets.size() / 4; }
  };

  /// Makes the box [0, size] of nx * ny * nz cells with six tets each. `size` is in m. The vertex at the cell corner
  /// (i, j, k) has the index (k * (ny + 1) + j) * (nx + 1) + i. Throws Error if a count is below 1 or a size is not
  /// positive.
  FASCIA_EXPORT Mesh make_box(int nx, int ny, int nz, const Vec3& size);

  /// Reads a mesh of tets, or of cells that become tets, from a Gmsh, VTK, TetGen, Medit, Abaqus, FEBio or Vega file.
  /// The content decides the format. Coordinates are taken as m. Throws Error with file and line for content that
  /// cannot be read, and Interrupted if `control` stops the work.
  FASCIA_EXPORT Mesh read_mesh(const std::string& path, const Control& control = {});

}  // namespace api
}  // namespace fascia
