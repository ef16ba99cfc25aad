#include "sim/fit/measured/shape_distance.h"

#include <Eigen/Geometry>

#include "sim/mesh/linear_tets.h"
#include "sim/mesh/tet_faces.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

std::vector<Triangle> boundary_of(const Model& model) {
  if (!model.has_quadratic()) return boundary_triangles(model.tets);
  return boundary_triangles(linear_tets(model.tets, model.mid_edges, model.rest_positions, 0, model.tets.size()).tets);
}

}  // namespace

std::vector<double> distances_to(const MeasuredShape& shape, const Model& model,
                                 const std::vector<Vector3d>& displacement) {
  std::vector<double> distances;
  distances.reserve(shape.value_count());
  if (!shape.vertices.empty()) {
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
      const std::uint32_t v = shape.vertices[i];
      for (const double d : Vector3d(model.rest_positions[v] + displacement[v] - shape.positions[i]))
        distances.push_back(d);
    }
    return distances;
  }
  std::vector<Vector3d> positions = model.rest_positions;
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += displacement[v];
  const TriangleTree tree(std::move(positions), boundary_of(model));
  for (const Vector3d& point : shape.positions) {
    const TriangleTree::Nearest nearest = tree.nearest(point);
    const Triangle& t = tree.triangles()[nearest.triangle];
    const auto& x = tree.positions();
    const Vector3d normal = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
    distances.push_back((point - nearest.point).dot(normal) < 0 ? -nearest.distance : nearest.distance);
  }
  return distances;
}

}  // namespace fascia
