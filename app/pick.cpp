#include "app/pick.h"

#include <algorithm>
#include <limits>

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Distance along the ray, infinite for a miss (Moeller, Trumbore 1997, without culling).
double distance_to(const Ray& ray, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, p = ray.direction.cross(ac);
  const double det = ab.dot(p);
  if (det == 0) return kInfinity;
  const Vector3d s = ray.origin - a, q = s.cross(ab);
  const double u = s.dot(p) / det, v = ray.direction.dot(q) / det, t = ac.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : kInfinity;
}

// The point of segment ab nearest to the line of the ray.
Vector3d nearest_on_segment(const Ray& ray, const Vector3d& a, const Vector3d& b) {
  const auto across = [&](const Vector3d& v) { return Vector3d(v - ray.direction * ray.direction.dot(v)); };
  const Vector3d ab = across(b - a), from = across(ray.origin - a);
  const double length2 = ab.squaredNorm();
  return a + (b - a) * (length2 > 0 ? std::clamp(from.dot(ab) / length2, 0.0, 1.0) : 0.0);
}

}  // namespace

std::optional<Hit> pick(const Ray& ray, std::span<const Triangle> triangles, std::span<const Vector3d> positions) {
  std::optional<Hit> hit;
  double nearest = kInfinity;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const double distance = distance_to(ray, positions[t[0]], positions[t[1]], positions[t[2]]);
    if (!(distance < nearest)) continue;
    nearest = distance;
    hit = Hit{i, ray.origin + distance * ray.direction};
  }
  return hit;
}

std::optional<Hit> pick_nearest(const Ray& ray, std::span<const Triangle> triangles, std::span<const Vector3d> positions) {
  if (auto hit = pick(ray, triangles, positions)) return hit;
  std::optional<Hit> hit;
  double nearest = kInfinity;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d point = nearest_on_segment(ray, positions[triangles[i][k]], positions[triangles[i][(k + 1) % 3]]);
      const Vector3d from_eye = point - ray.origin;
      const double along = ray.direction.dot(from_eye);
      if (along <= 0) continue;  // behind the eye
      const double distance = (from_eye - along * ray.direction).squaredNorm();
      if (!(distance < nearest)) continue;
      nearest = distance;
      hit = Hit{i, point};
    }
  }
  return hit;
}

}  // namespace fascia
