#include "app/bench/fill/fill.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/mesh_check.h"
#include "sim/mesh/tet_faces.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr int kQuickResolution = 12;

/// The largest distance of points all over `from` to `to`: corners, and places inside of the triangles.
double farthest(const TriangleTree& from, const TriangleTree& to) {
  constexpr int kParts = 4;  // of each side of a triangle
  double distance = 0;
  const auto& x = from.positions();
  for (const Triangle& t : from.triangles())
    for (int i = 0; i <= kParts; ++i)
      for (int j = 0; i + j <= kParts; ++j) {
        const double a = double(i) / kParts, b = double(j) / kParts;
        const Vector3d p = (1 - a - b) * x[t[0]] + a * x[t[1]] + b * x[t[2]];
        distance = std::max(distance, to.nearest(p).distance);
      }
  return distance;
}

}  // namespace

FillQuality fill_quality(const Shape& shape, std::optional<int> resolution) {
  const FilledSurface filled = fill_surface(shape.surface, shape.name, resolution);
  const MeshReport report = examine(filled.file.mesh, repair(filled.file.mesh));
  const TriangleTree surface(filled.repaired.positions, filled.repaired.triangles);
  const TriangleTree boundary(filled.file.mesh.positions, boundary_triangles(filled.file.mesh.tets));
  const double longest = filled.repaired.report.box.sizes().maxCoeff();
  FillQuality quality;
  quality.resolution = filled.resolution;
  quality.tets = filled.file.mesh.tets.size();
  quality.smallest_dihedral_deg = report.smallest_dihedral_deg;
  quality.largest_dihedral_deg = report.largest_dihedral_deg;
  quality.volume_error = report.volume / filled.repaired.report.volume - 1;
  quality.distance = std::max(farthest(surface, boundary), farthest(boundary, surface)) / longest;
  quality.spacings = quality.distance * filled.resolution;
  quality.notes.assign(filled.file.notes.begin() + filled.notes_of_surface, filled.file.notes.end());
  return quality;
}

Table fill_table(bool quick) {
  Table table;
  table.columns = {
      "shape",         "resolution",      "tets", "smallest_dihedral_deg", "largest_dihedral_deg", "volume_error",
      "distance_size", "distance_spacing"};
  for (const Shape& shape : fill_shapes()) {
    std::vector<std::optional<int>> resolutions{quick ? std::optional<int>(kQuickResolution) : std::nullopt};
    while (!resolutions.empty()) {
      const FillQuality q = fill_quality(shape, resolutions.back());
      const bool coarse = !resolutions.back() && !quick;
      resolutions.pop_back();
      if (coarse) resolutions.emplace_back(std::min(2 * q.resolution, kMostCells));
      table.rows.push_back({shape.name, q.resolution, q.tets, q.smallest_dihedral_deg, q.largest_dihedral_deg,
                            q.volume_error, q.distance, q.spacings});
    }
  }
  return table;
}

}  // namespace fascia
