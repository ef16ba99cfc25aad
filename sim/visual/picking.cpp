#include "sim/visual/picking.h"

#include <algorithm>
#include <limits>

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kEndless = std::numeric_limits<double>::infinity();

// Distance along the ray, infinite for a miss (Moeller, Trumbore 1997, without culling).
double distance_to(const Ray& ray, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, p = ray.direction.cross(ac);
  const double det = ab.dot(p);
  if (det == 0) return kEndless;
  const Vector3d s = ray.origin - a, q = s.cross(ab);
  const double u = s.dot(p) / det, v = ray.direction.dot(q) / det, t = ac.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : kEndless;
}

// The point of segment ab nearest to the line of the ray.
Vector3d nearest_on_segment(const Ray& ray, const Vector3d& a, const Vector3d& b) {
  const auto across = [&](const Vector3d& v) { return Vector3d(v - ray.direction * ray.direction.dot(v)); };
  const Vector3d ab = across(b - a), from = across(ray.origin - a);
  const double length2 = ab.squaredNorm();
  return a + (b - a) * (length2 > 0 ? std::clamp(from.dot(ab) / length2, 0.0, 1.0) : 0.0);
}

double beyond(const SectionCut& cut, const Vector3d& p) { return cut.normal.cast<double>().dot(p) - cut.offset; }

// The part of the ray [m] on which the body is visible; empty if low > high.
struct Reach {
  double low = 0, high = kEndless;
};

Reach reach_of(const Ray& ray, const Cut& cut) {
  if (!cut) return {};
  const double away = beyond(*cut, ray.origin), slope = cut->normal.cast<double>().dot(ray.direction),
               crossing = -away / slope;
  if (away > 0) return slope < 0 ? Reach{crossing, kEndless} : Reach{kEndless, 0};
  return slope > 0 ? Reach{0, crossing} : Reach{};
}

Vector3d normal_of(const Triangle& t, std::span<const Vector3d> positions) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).normalized();
}

}  // namespace

std::optional<Hit> pick(const Ray& ray, std::span<const Triangle> triangles, std::span<const Vector3d> positions,
                        const Cut& cut) {
  const Reach reach = reach_of(ray, cut);
  std::optional<std::size_t> first;
  double nearest = kEndless;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const double distance = distance_to(ray, positions[t[0]], positions[t[1]], positions[t[2]]);
    if (!(distance < nearest) || distance < reach.low || distance > reach.high) continue;
    nearest = distance;
    first = i;
  }
  if (!first) return std::nullopt;
  const Vector3d normal = normal_of(triangles[*first], positions);
  // Seen from its inside: the ray entered through the cut.
  if (reach.low > 0 && normal.dot(ray.direction) > 0)
    return Hit{*first, ray.origin + reach.low * ray.direction, cut->normal.cast<double>(), true};
  return Hit{*first, ray.origin + nearest * ray.direction, normal};
}

std::optional<Hit> pick_nearest(const Ray& ray, std::span<const Triangle> triangles,
                                std::span<const Vector3d> positions, const Cut& cut) {
  if (auto hit = pick(ray, triangles, positions, cut)) return hit;
  std::optional<Hit> hit;
  double nearest = kEndless;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d point = nearest_on_segment(ray, positions[triangles[i][k]], positions[triangles[i][(k + 1) % 3]]);
      const Vector3d from_eye = point - ray.origin;
      const double along = ray.direction.dot(from_eye);
      if (along <= 0 || (cut && beyond(*cut, point) > 0)) continue;  // behind the camera
      const double distance = (from_eye - along * ray.direction).squaredNorm();
      if (!(distance < nearest)) continue;
      nearest = distance;
      hit = Hit{i, point, normal_of(triangles[i], positions)};
    }
  }
  return hit;
}

}  // namespace fascia
