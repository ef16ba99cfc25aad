#include "sim/visual/visual_surface.h"

#include <algorithm>

#include "sim/mesh/tet_faces.h"

namespace fascia {

VisualSurface drawn_surface(const Model& model) {
  VisualSurface drawn;
  drawn.rest_positions = model.rest_positions;
  const bool colored =
      std::any_of(model.surfaces.begin(), model.surfaces.end(), [](const SurfaceMesh& s) { return !s.colors.empty(); });
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const SurfaceMesh& surface = model.surfaces[b];
    if (surface.triangles.empty()) {
      const auto first = model.tets.begin() + model.bodies[b].tet_begin;
      const std::vector<Triangle> boundary = boundary_triangles({first, first + model.bodies[b].tet_count});
      drawn.triangles.insert(drawn.triangles.end(), boundary.begin(), boundary.end());
    } else {
      const auto offset = static_cast<std::uint32_t>(drawn.rest_positions.size());
      for (const Triangle& t : surface.triangles)
        drawn.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
      drawn.rest_positions.insert(drawn.rest_positions.end(), surface.positions.begin(), surface.positions.end());
      drawn.colors.insert(drawn.colors.end(), surface.colors.begin(), surface.colors.end());
    }
    if (colored) drawn.colors.resize(3 * drawn.triangles.size(), 0);
  }
  return drawn;
}

bool closed_around_tets(const Model& model) {
  const auto own = [](const SurfaceMesh& s) { return !s.triangles.empty(); };
  return std::any_of(model.surfaces.begin(), model.surfaces.end(), own) &&
         std::all_of(model.surfaces.begin(), model.surfaces.end(),
                     [&](const SurfaceMesh& s) { return !own(s) || s.closed; });
}

}  // namespace fascia
