#include "sim/bare_mesh/foot.h"

#include <algorithm>
#include <limits>

namespace fascia {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Counterclockwise (Andrew 1979).
std::vector<Vector2d> convex_hull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const Vector2d& a, const Vector2d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() >= begin + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the first point of the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

double stability(std::vector<Vector2d> contact, const Vector2d& center, double height) {
  if (contact.size() < 3) return -1;
  const std::vector<Vector2d> hull = convex_hull(std::move(contact));
  if (hull.size() < 3) return -1;
  double inside = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vector2d &a = hull[k], edge = hull[(k + 1) % hull.size()] - a;
    inside = std::min(inside, cross(edge, center - a) / edge.norm());
  }
  return inside / height;
}

}  // namespace fascia
