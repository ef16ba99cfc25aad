// Closed surfaces from formulas, for tests of filling and drawing.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/surface/surface_mesh.h"

namespace fascia::test {

/// A ball with rings and meridians, wound outward.
inline SurfaceMesh make_sphere(int rings, int around, double radius, const Eigen::Vector3d& center = {0, 0, 0}) {
  SurfaceMesh s;
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(i == 0       ? 0
                                      : i == rings ? 1 + (rings - 1) * around
                                                   : 1 + (i - 1) * around + j % around);
  };
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < (i == 0 || i == rings ? 1 : around); ++j) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / around;
      s.positions.push_back(
          center + radius * Eigen::Vector3d(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)));
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      if (i > 0) s.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      if (i + 1 < rings) s.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return s;
}

/// Around the y axis, wound outward.
inline SurfaceMesh make_torus(int around, int section, double radius, double thickness) {
  SurfaceMesh s;
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * section + j % section); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < section; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / section;
      const double r = radius + thickness * std::cos(b);
      s.positions.emplace_back(r * std::cos(a), thickness * std::sin(b), r * std::sin(a));
      s.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      s.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return s;
}

/// A box of 12 triangles, wound outward.
inline SurfaceMesh make_box_surface(const Eigen::Vector3d& size) {
  SurfaceMesh s;
  for (int v = 0; v < 8; ++v) s.positions.push_back(size.cwiseProduct(Eigen::Vector3d(v >> 2, v >> 1 & 1, v & 1)));
  constexpr std::uint32_t quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                         {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& q : quads) {
    s.triangles.push_back({q[0], q[1], q[2]});
    s.triangles.push_back({q[0], q[2], q[3]});
  }
  return s;
}

inline SurfaceMesh turned(SurfaceMesh s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

inline SurfaceMesh joined(SurfaceMesh a, const SurfaceMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

inline double enclosed_volume(const SurfaceMesh& s) {
  double volume = 0;
  for (const auto& [a, b, c] : s.triangles) volume += s.positions[a].cross(s.positions[b]).dot(s.positions[c]) / 6;
  return volume;
}

}  // namespace fascia::test
