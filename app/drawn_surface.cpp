#include "app/drawn_surface.h"

#include "sim/surface.h"
#include "sim/surface_mesh.h"

namespace fascia {
namespace {

SurfaceMesh placed_surface(const Scene& scene, const Body& body) {
  SurfaceMesh surface = read_obj(scene.resolve(body.surface));
  const Eigen::Affine3d place = placement(body.transform);
  for (Eigen::Vector3d& p : surface.positions) p = place * p;
  return surface;
}

}  // namespace

std::vector<Eigen::Vector3d> embedded_points(const Scene& scene) {
  std::vector<Eigen::Vector3d> points;
  for (const Body& body : scene.bodies) {
    if (body.surface.empty()) continue;
    const SurfaceMesh surface = placed_surface(scene, body);
    points.insert(points.end(), surface.positions.begin(), surface.positions.end());
  }
  return points;
}

DrawnSurface drawn_surface(const Scene& scene, const Model& model) {
  DrawnSurface drawn;
  drawn.rest_positions = model.rest_positions;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (scene.bodies[b].surface.empty()) {
      const auto first = model.tets.begin() + model.bodies[b].tet_begin;
      const std::vector<Triangle> boundary = boundary_triangles({first, first + model.bodies[b].tet_count});
      drawn.triangles.insert(drawn.triangles.end(), boundary.begin(), boundary.end());
      continue;
    }
    const SurfaceMesh surface = placed_surface(scene, scene.bodies[b]);
    const auto offset = static_cast<std::uint32_t>(drawn.rest_positions.size());
    for (const Triangle& t : surface.triangles)
      drawn.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    drawn.rest_positions.insert(drawn.rest_positions.end(), surface.positions.begin(), surface.positions.end());
  }
  return drawn;
}

}  // namespace fascia
