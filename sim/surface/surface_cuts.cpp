// Finds self-intersections of a surface.
#include <algorithm>

#include "sim/surface/surface_repair.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// Pairs of boxes that are compared for each triangle. Surfaces of well-shaped triangles need some 50; where thousands
// of long triangles lie across each other every pair would be compared.
constexpr std::size_t kMostPairsEach = 200;
constexpr std::size_t kPairsBetweenReports = 1 << 16;

using TriangleCorners = std::array<Vector3d, 3>;

/// Six times the volumes under the corners of `t` over `base`: their signs are the sides of its plane on which they
/// lie.
std::array<double, 3> sides(const TriangleCorners& t, const TriangleCorners& base) {
  const Vector3d normal = (base[1] - base[0]).cross(base[2] - base[0]);
  return {normal.dot(t[0] - base[0]), normal.dot(t[1] - base[0]), normal.dot(t[2] - base[0])};
}

bool on_one_side(const std::array<double, 3>& side) {
  const auto [low, high] = std::minmax_element(side.begin(), side.end());
  return !(*low < 0 && *high > 0);
}

/// Whether an edge of `t`, whose corners lie on these sides of the other triangle's plane, passes through that
/// triangle.
bool pierces(const TriangleCorners& t, const std::array<double, 3>& side, const TriangleCorners& other,
             Vector3d& where) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (!(side[k] * side[next] < 0)) continue;
    const Vector3d &a = t[k], &b = t[next];
    const double s0 = signed_volume6(a, b, other[0], other[1]), s1 = signed_volume6(a, b, other[1], other[2]),
                 s2 = signed_volume6(a, b, other[2], other[0]);
    if (!((s0 > 0 && s1 > 0 && s2 > 0) || (s0 < 0 && s1 < 0 && s2 < 0))) continue;
    where = a + (b - a) * (side[k] / (side[k] - side[next]));
    return true;
  }
  return false;
}

/// Whether two triangles intersect. A triangle on one side of the other's plane does not.
bool cut(const TriangleCorners& one, const TriangleCorners& other, Vector3d& where) {
  const std::array<double, 3> of_one = sides(one, other);
  if (on_one_side(of_one)) return false;
  const std::array<double, 3> of_other = sides(other, one);
  return !on_one_side(of_other) && (pierces(one, of_one, other, where) || pierces(other, of_other, one, where));
}

}  // namespace

SelfIntersections self_intersections(const TriangleTree& tree, const Progress& progress) {
  SelfIntersections found;
  const std::vector<Triangle>& triangles = tree.triangles();
  const auto corners = [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    return TriangleCorners{tree.positions()[a], tree.positions()[b], tree.positions()[c]};
  };
  std::array<std::size_t, 2> first{triangles.size(), triangles.size()};
  std::size_t next_report = 0;
  const std::size_t most = kMostPairsEach * triangles.size();
  found.complete = tree.for_touching_pairs(
      [&](std::size_t t, std::size_t other) {
        Vector3d where;
        if (!cut(corners(t), corners(other), where)) return;
        ++found.pairs.count;
        if (std::array{t, other} > first) return;
        first = {t, other};
        found.pairs.first = where;
      },
      [&](std::size_t looked_at) {
        if (looked_at >= next_report) {
          next_report = looked_at + kPairsBetweenReports;
          report(progress, static_cast<double>(looked_at) / static_cast<double>(most),
                 "Looking for triangles that cut each other");
        }
        return looked_at < most;
      });
  return found;
}

}  // namespace fascia
