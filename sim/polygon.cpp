#include "sim/polygon.h"

#include <limits>

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners in the plane across the polygon's area vector (Newell), so that they lead around it counterclockwise.
std::vector<Vector2d> flattened(const std::vector<Vector3d>& positions, const std::vector<std::uint32_t>& corners) {
  const Vector3d& origin = positions[corners[0]];
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += (positions[corners[i]] - origin).cross(positions[corners[(i + 1) % corners.size()]] - origin);
  const Vector3d normal = area.stableNormalized();
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector2d> flat;
  for (const std::uint32_t corner : corners) flat.emplace_back(u.dot(positions[corner] - origin), v.dot(positions[corner] - origin));
  return flat;
}

class EarClipper {
 public:
  explicit EarClipper(std::vector<Vector2d> flat) : flat_(std::move(flat)) {
    for (std::size_t i = 0; i < flat_.size(); ++i) left_.push_back(i);
  }

  /// The three corners of the next triangle; the middle one is cut off.
  std::array<std::size_t, 3> next() {
    std::size_t best = 0;
    double shortest = std::numeric_limits<double>::infinity(), sharpest = -shortest;
    bool found = false;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const auto [a, b, c] = around(i);
      const double turn = cross(flat_[b] - flat_[a], flat_[c] - flat_[b]);
      if (turn > 0 && is_empty(a, b, c)) {
        const double cut = (flat_[c] - flat_[a]).squaredNorm();
        if (found && cut >= shortest) continue;
        shortest = cut;
        found = true;
        best = i;
      } else if (!found && turn > sharpest) {
        sharpest = turn;
        best = i;
      }
    }
    const std::array<std::size_t, 3> ear = around(best);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(best));
    return ear;
  }

 private:
  std::array<std::size_t, 3> around(std::size_t i) const {
    const std::size_t n = left_.size();
    return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
  }
  bool is_empty(std::size_t a, std::size_t b, std::size_t c) const {
    for (const std::size_t other : left_) {
      const Vector2d& p = flat_[other];
      if (other == a || other == b || other == c || p == flat_[a] || p == flat_[c]) continue;
      if (cross(flat_[b] - flat_[a], p - flat_[a]) >= 0 && cross(flat_[c] - flat_[b], p - flat_[b]) >= 0 &&
          cross(flat_[a] - flat_[c], p - flat_[c]) >= 0)
        return false;
    }
    return true;
  }

  std::vector<Vector2d> flat_;
  std::vector<std::size_t> left_;  // corners not yet cut off
};

}  // namespace

void triangulate(const std::vector<Vector3d>& positions, const std::vector<std::uint32_t>& corners, std::vector<Triangle>& triangles) {
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
