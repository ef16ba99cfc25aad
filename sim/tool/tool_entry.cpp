#include "sim/tool/tool_entry.h"

#include <algorithm>

namespace fascia {

using Eigen::Vector3d;

namespace {

std::optional<ToolEntry> entry_on(const ToolShape& shape, const Vector3d& from, const Vector3d& to,
                                  double half_thickness) {
  constexpr double kNear = 0.01;     // of the way
  constexpr double kSameSide = 0.5;  // least cosine between the normals at the entry and at the end
  const Vector3d way = to - from;
  const double size = way.norm();
  if (size <= finest_radius(shape)) return std::nullopt;  // no other side can be nearer
  double share = 0;
  for (std::uint32_t k = 0;; ++k) {
    const double d = distance_to(shape, from + share * way).distance - half_thickness;
    if (d <= kNear * size) break;
    share += d / size;
    if (share >= 1 || k + 1 == kEntrySteps) return std::nullopt;
  }
  const Vector3d place = from + share * way;
  const ShapeDistance at_entry = distance_to(shape, place), at_end = distance_to(shape, to);
  const Vector3d behind = place + std::min((1 - share) * size, finest_radius(shape)) / size * way;
  const double deepest = std::min(at_end.distance, distance_to(shape, behind).distance) - half_thickness;
  if (deepest >= -kNear * size || at_entry.normal.dot(at_end.normal) >= kSameSide) return std::nullopt;
  const Vector3d normal = at_entry.normal.normalized();
  return ToolEntry{normal, normal.dot(place) - at_entry.distance};
}

}  // namespace

std::optional<ToolEntry> entry_into(const ToolShape& shape, const Vector3d& from, const Vector3d& to,
                                    const Vector3d& stay, double half_thickness) {
  if (const auto entry = entry_on(shape, from, to, half_thickness)) return entry;
  return entry_on(shape, from, stay, half_thickness);
}

}  // namespace fascia
