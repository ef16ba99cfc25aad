#include "sim/bare_mesh/flat_sides.h"

#include <algorithm>
#include <cmath>

#include "sim/bare_mesh/foot.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFlatDepth = 0.02;      // of the extent along the axis
constexpr double kFlatCosine = 0.96593;  // of 15 degrees

FlatSide side_at(const std::vector<Vector3d>& x, const std::vector<Triangle>& boundary, const Bulk& bulk, int axis,
                 double sign) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vector3d size = bulk.box.sizes();
  const double end = sign > 0 ? bulk.box.max()[axis] : bulk.box.min()[axis];
  FlatSide side;
  std::vector<Vector2d> contact;
  for (const Triangle& t : boundary) {
    if (std::any_of(t.begin(), t.end(),
                    [&](std::uint32_t i) { return std::abs(x[i][axis] - end) > kFlatDepth * size[axis]; }))
      continue;
    const Vector3d area = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]) / 2;
    if (!(sign * area[axis] > kFlatCosine * area.norm())) continue;
    side.area += sign * area[axis];
    for (const std::uint32_t i : t) contact.emplace_back(x[i][u], x[i][v]);
  }
  if (side.area == 0) return side;
  side.share = side.area / (size[u] * size[v]);
  side.stability = stability(std::move(contact), {bulk.center[u], bulk.center[v]}, std::abs(bulk.center[axis] - end));
  return side;
}

}  // namespace

Bulk bulk_of(const std::vector<Vector3d>& x, const std::vector<Tet>& tets) {
  Bulk bulk;
  for (const Tet& t : tets) {
    const double volume = signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6;
    bulk.volume += volume;
    for (const std::uint32_t v : t) {
      bulk.center += volume / 4 * x[v];
      bulk.box.extend(x[v]);
    }
  }
  bulk.center /= bulk.volume;
  return bulk;
}

FlatSides flat_sides(const std::vector<Vector3d>& positions, const std::vector<Tet>& tets) {
  const Bulk bulk = bulk_of(positions, tets);
  const std::vector<Triangle> boundary = boundary_triangles(tets);
  FlatSides sides;
  sides.size = bulk.box.sizes();
  for (int axis = 0; axis < 3; ++axis) {
    sides.low[static_cast<std::size_t>(axis)] = side_at(positions, boundary, bulk, axis, -1);
    sides.high[static_cast<std::size_t>(axis)] = side_at(positions, boundary, bulk, axis, 1);
  }
  return sides;
}

}  // namespace fascia
