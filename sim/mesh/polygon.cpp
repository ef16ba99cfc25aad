#include "sim/mesh/polygon.h"

#include <array>

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners projected to the plane perpendicular to the polygon's area vector (Newell), counterclockwise.
std::vector<Vector2d> flattened(const std::vector<Vector3d>& positions, const std::vector<std::uint32_t>& corners) {
  const Vector3d& origin = positions[corners[0]];
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += (positions[corners[i]] - origin).cross(positions[corners[(i + 1) % corners.size()]] - origin);
  const Vector3d normal = area.stableNormalized();
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector2d> flat;
  for (const std::uint32_t corner : corners)
    flat.emplace_back(u.dot(positions[corner] - origin), v.dot(positions[corner] - origin));
  return flat;
}

/// Stores for each corner whether it is an ear and, if not, a corner that blocks it: it is tested again only when the
/// blocking corner or a neighbor is removed.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Vector2d> flat) : flat_(std::move(flat)), corners_(flat_.size()) {
    const std::size_t n = flat_.size();
    for (std::size_t i = 0; i < n; ++i) corners_[i] = {(i + n - 1) % n, (i + 1) % n, 0, 0, kNone, false};
    for (std::size_t i = 0; i < n; ++i) look_at(i);
  }

  /// The three corners of the next triangle; the middle one is cut off.
  std::array<std::size_t, 3> next() {
    std::size_t best = kNone;
    for (std::size_t i = first_, count = 0; count < left(); i = corners_[i].next, ++count)
      if (best == kNone || is_better(i, best)) best = i;
    const std::array<std::size_t, 3> ear{corners_[best].previous, best, corners_[best].next};
    corners_[ear[0]].next = ear[2];
    corners_[ear[2]].previous = ear[0];
    if (first_ == best) first_ = ear[2];
    ++cut_off_;
    look_at(ear[0]);
    look_at(ear[2]);
    for (std::size_t i = first_, count = 0; count < left(); i = corners_[i].next, ++count)
      if (corners_[i].in_the_way == best) look_at(i);
    return ear;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Corner {
    std::size_t previous, next;
    double turn, cut;        // convex if turn > 0; squared length of the cut
    std::size_t in_the_way;  // a blocking corner in its triangle
    bool is_ear;
  };

  std::size_t left() const { return flat_.size() - cut_off_; }

  /// The ear with the shortest cut or, without ears, the sharpest corner.
  bool is_better(std::size_t i, std::size_t than) const {
    const Corner &a = corners_[i], &b = corners_[than];
    return a.is_ear != b.is_ear ? a.is_ear : a.is_ear ? a.cut < b.cut : a.turn > b.turn;
  }

  void look_at(std::size_t i) {
    Corner& corner = corners_[i];
    const Vector2d &a = flat_[corner.previous], &b = flat_[i], &c = flat_[corner.next];
    corner.turn = cross(b - a, c - b);
    corner.cut = (c - a).squaredNorm();
    corner.in_the_way = corner.turn > 0 ? in_triangle(corner.previous, i, corner.next) : kNone;
    corner.is_ear = corner.turn > 0 && corner.in_the_way == kNone;
  }

  std::size_t in_triangle(std::size_t a, std::size_t b, std::size_t c) const {
    for (std::size_t other = corners_[c].next; other != a; other = corners_[other].next) {
      const Vector2d& p = flat_[other];
      if (p == flat_[a] || p == flat_[c]) continue;
      if (cross(flat_[b] - flat_[a], p - flat_[a]) >= 0 && cross(flat_[c] - flat_[b], p - flat_[b]) >= 0 &&
          cross(flat_[a] - flat_[c], p - flat_[c]) >= 0)
        return other;
    }
    return kNone;
  }

  std::vector<Vector2d> flat_;
  std::vector<Corner> corners_;  // a ring of the remaining corners
  std::size_t first_ = 0, cut_off_ = 0;
};

}  // namespace

void triangulate(const std::vector<Vector3d>& positions, const std::vector<std::uint32_t>& corners,
                 std::vector<Triangle>& triangles) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  EarClipper clipper(flattened(positions, corners));
  for (std::size_t left = corners.size(); left > 2; --left) {
    const auto [a, b, c] = clipper.next();
    triangles.push_back({corners[a], corners[b], corners[c]});
  }
}

}  // namespace fascia
