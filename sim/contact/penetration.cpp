#include "sim/contact/penetration.h"

#include "sim/contact/tissue_surface.h"
#include "sim/surface/surface_repair.h"

namespace fascia {

using Eigen::Vector3d;

bool goes_through(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double above = signed_volume6(a, b, c, p), below = signed_volume6(a, b, c, q);
  if ((above > 0) == (below > 0) || above == 0 || below == 0) return false;
  const bool ab = signed_volume6(p, q, a, b) > 0, bc = signed_volume6(p, q, b, c) > 0,
             ca = signed_volume6(p, q, c, a) > 0;
  return ab == bc && bc == ca;
}

std::size_t penetrating_triangles(const Model& model, const std::vector<Vector3d>& displacement) {
  std::vector<Vector3d> positions = model.rest_positions;
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += displacement[v];
  return self_intersections(TriangleTree(std::move(positions), tissue_boundary(model))).pairs.count;
}

}  // namespace fascia
