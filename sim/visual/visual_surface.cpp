#include "sim/visual/visual_surface.h"

#include <algorithm>

#include "sim/mesh/linear_tets.h"
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
      const BodyPart& body = model.bodies[b];
      const std::vector<Triangle> boundary = boundary_triangles(
          linear_tets(model.tets, model.mid_edges, model.rest_positions, body.tet_begin, body.tet_count).tets);
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

std::vector<std::uint32_t> drawn_marks(const Model& model, const std::vector<std::uint32_t>& vertices) {
  if (model.embedded.points.empty()) return vertices;
  constexpr double kNear = 0.4;  // weight of a mesh vertex, up to which an embedded one is not at its place
  struct Nearest {
    double weight = kNear;
    std::uint32_t embedded = 0;
  };
  const auto count = static_cast<std::uint32_t>(model.rest_positions.size());
  std::vector<Nearest> nearest(count);
  const auto compare = [&](std::uint32_t vertex, double weight, std::uint32_t point) {
    if (Nearest& now = nearest[vertex]; weight > now.weight) now = {weight, count + point};
  };
  for (std::uint32_t i = 0; i < model.embedded.ties.size(); ++i) {
    const EmbeddedPoint& tie = model.embedded.ties[i];
    for (std::size_t k = 0; k < 4; ++k) compare(tie.vertices[k], tie.weights[k], i);
    if (model.embedded.quadratic.empty()) continue;
    const QuadraticTie& curved = model.embedded.quadratic[i];
    for (std::size_t m = 0; m < 6 && curved.middles != kNoMidEdges; ++m)
      compare(curved.middles[m], curved.weights[4 + m], i);
  }
  std::vector<std::uint32_t> marks;
  for (const std::uint32_t v : vertices) {
    const auto body = std::find_if(model.bodies.begin(), model.bodies.end(), [&](const BodyPart& part) {
      return v >= part.vertex_begin && v < part.vertex_begin + part.vertex_count;
    });
    const bool has_surface = body != model.bodies.end() &&
                             !model.surfaces[static_cast<std::size_t>(body - model.bodies.begin())].triangles.empty();
    if (!has_surface)
      marks.push_back(v);
    else if (nearest[v].embedded > 0)
      marks.push_back(nearest[v].embedded);
  }
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  return marks;
}

bool closed_around_tets(const Model& model) {
  const auto own = [](const SurfaceMesh& s) { return !s.triangles.empty(); };
  return std::any_of(model.surfaces.begin(), model.surfaces.end(), own) &&
         std::all_of(model.surfaces.begin(), model.surfaces.end(),
                     [&](const SurfaceMesh& s) { return !own(s) || s.closed; });
}

}  // namespace fascia
