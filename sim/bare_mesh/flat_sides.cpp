#include "sim/bare_mesh/flat_sides.h"

#include <algorithm>
#include <cmath>

#include "sim/bare_mesh/foot.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFlatDepth = 0.02;      // of the extent along the axis, within which a part is flat
constexpr double kRim = 0.1;             // of the extent, by which a rim may stand out beyond it
constexpr double kFlatCosine = 0.96593;  // of 15 degrees

FlatSide side_at(const std::vector<Vector3d>& x, const std::vector<Triangle>& boundary, const Bulk& bulk, int axis,
                 double sign) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vector3d size = bulk.box.sizes();
  const double end = sign > 0 ? bulk.box.max()[axis] : bulk.box.min()[axis];
  struct Facing {
    double least, most;  // depth below the end, as a share of the extent
    double area;
    Triangle triangle;
  };
  std::vector<Facing> facing;
  for (const Triangle& t : boundary) {
    const Vector3d area = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]) / 2;
    if (!(sign * area[axis] > kFlatCosine * area.norm())) continue;
    const auto [least, most] =
        std::minmax({std::abs(x[t[0]][axis] - end), std::abs(x[t[1]][axis] - end), std::abs(x[t[2]][axis] - end)});
    if (most <= (kRim + kFlatDepth) * size[axis])
      facing.push_back({least / size[axis], most / size[axis], sign * area[axis], t});
  }
  FlatSide side;
  double from = 0;
  for (double begin = 0; begin <= kRim; begin += kFlatDepth / 2) {
    double area = 0;
    for (const Facing& f : facing)
      if (f.least >= begin && f.most <= begin + kFlatDepth) area += f.area;
    if (area <= side.area) continue;
    side.area = area;
    from = begin;
  }
  if (side.area == 0) return side;
  std::vector<Vector2d> contact;
  for (const Facing& f : facing) {
    if (f.least < from || f.most > from + kFlatDepth) continue;
    side.depth = std::max(side.depth, from == 0 ? 0 : f.most);
    for (const std::uint32_t i : f.triangle) contact.emplace_back(x[i][u], x[i][v]);
  }
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
