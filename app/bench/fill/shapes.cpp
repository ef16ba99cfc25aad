#include "app/bench/fill/shapes.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "base/file.h"
#include "base/number_text.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 2 * std::numbers::pi;

/// To a picometer, so that all vertices at a pole have one position; without a negative zero.
Vector3d rounded(const Vector3d& p) { return (p * 1e12).array().round() / 1e12 + 0.0; }

/// A grid of quads over [0, 1] x [0, 1], each in two triangles; `around` and `along`: whether u and v close. Rows that
/// collapse to a point become triangles.
SurfaceMesh grid(int nu, int nv, bool around, bool along, const std::function<Vector3d(double, double)>& at) {
  SurfaceMesh surface;
  const int rows = along ? nv : nv + 1, columns = around ? nu : nu + 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) surface.positions.push_back(rounded(at(double(i) / nu, double(j) / nv)));
  const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(j % rows * columns + i % columns); };
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      surface.triangles.push_back({a, b, c});
      surface.triangles.push_back({a, c, d});
    }
  return surface;
}

/// A profile (radius, height) from bottom to top, turned about y; its ends lie on the axis.
SurfaceMesh turned(int points, const std::function<Eigen::Vector2d(double)>& profile) {
  return grid(48, points, true, false, [&](double u, double v) {
    const Eigen::Vector2d p = profile(v);
    return Vector3d(p.x() * std::sin(kTurn * u), p.y(), p.x() * std::cos(kTurn * u));
  });
}

/// A broken line of (radius, height) as a profile: `points` per side.
SurfaceMesh turned(const std::vector<Eigen::Vector2d>& corners) {
  constexpr int kPoints = 12;
  const int sides = static_cast<int>(corners.size()) - 1;
  return turned(kPoints * sides, [&](double v) -> Eigen::Vector2d {
    const double at = v * sides;
    const auto side = static_cast<std::size_t>(std::min(sides - 1.0, std::floor(at)));
    return corners[side] + (at - static_cast<double>(side)) * (corners[side + 1] - corners[side]);
  });
}

/// A closed tube of this radius along a closed curve.
SurfaceMesh tube(int points, double radius, const std::function<Vector3d(double)>& curve) {
  return grid(16, points, true, true, [&](double u, double v) {
    constexpr double kStep = 1e-4;
    const Vector3d along = (curve(v + kStep) - curve(v - kStep)).normalized();
    const Vector3d side = along.cross(Vector3d(0.1, 1, 0.2)).normalized(), up = side.cross(along);
    return Vector3d(curve(v) + radius * (std::cos(kTurn * u) * side + std::sin(kTurn * u) * up));
  });
}

/// Radius as a function of the direction.
SurfaceMesh star(const std::function<double(const Vector3d&)>& radius) {
  return grid(64, 40, true, false, [&](double u, double v) {
    const double polar = std::numbers::pi * (1 - v);
    const Vector3d d(std::sin(polar) * std::sin(kTurn * u), std::cos(polar), std::sin(polar) * std::cos(kTurn * u));
    return Vector3d(radius(d) * d);
  });
}

SurfaceMesh box(const Vector3d& size) {
  SurfaceMesh surface;
  for (int i = 0; i < 8; ++i) surface.positions.push_back(size.cwiseProduct(Vector3d(i & 1, i >> 1 & 1, i >> 2)));
  surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return surface;
}

SurfaceMesh tetrahedron() {
  SurfaceMesh surface;
  surface.positions = {{0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}, {0, 0, 0.2}};
  surface.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return surface;
}

/// `inner` becomes a cavity of `outer`.
SurfaceMesh hollow(SurfaceMesh outer, const SurfaceMesh& inner) {
  const auto offset = static_cast<std::uint32_t>(outer.positions.size());
  outer.positions.insert(outer.positions.end(), inner.positions.begin(), inner.positions.end());
  for (const Triangle& t : inner.triangles) outer.triangles.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
  return outer;
}

}  // namespace

std::vector<Shape> fill_shapes() {
  const auto ball = [](double radius) { return star([radius](const Vector3d&) { return radius; }); };
  return {
      {"sphere", ball(0.1)},
      {"ellipsoid", star([](const Vector3d& d) { return 1 / d.cwiseQuotient(Vector3d(0.1, 0.06, 0.04)).norm(); })},
      {"liver", star([](const Vector3d& d) {
         return 0.08 + 0.02 * std::sin(3 * d.x() + 1) * std::cos(2 * d.y()) + 0.015 * std::sin(4 * d.z());
       })},
      {"brain",
       star([](const Vector3d& d) { return 0.09 + 0.006 * std::sin(14 * d.x()) * std::sin(13 * d.y() + 2 * d.z()); })},
      {"kidney", star([](const Vector3d& d) {
         return (0.1 - 0.04 * std::exp(-8 * (d - Vector3d(0, 0, 1)).squaredNorm())) * (0.7 + 0.3 * d.y() * d.y());
       })},
      {"heart", star([](const Vector3d& d) { return 0.095 + 0.034 * d.y() - 0.027 * std::abs(d.x()) * d.y(); })},
      {"cube", box({0.2, 0.2, 0.2})},
      {"brick", box({0.2, 0.1, 0.05})},
      {"plate", box({0.2, 0.2, 0.01})},
      {"tetrahedron", tetrahedron()},
      {"cylinder", turned({{0, 0}, {0.05, 0}, {0.05, 0.2}, {0, 0.2}})},
      {"cone", turned({{0, 0}, {0.08, 0}, {0, 0.2}})},
      {"capsule", turned(60,
                         [](double v) -> Eigen::Vector2d {
                           const double angle = std::numbers::pi * (v - 0.5);
                           return {0.04 * std::cos(angle),
                                   0.1 + 0.04 * std::sin(angle) + 0.06 * std::clamp(8 * (v - 0.5), -1.0, 1.0)};
                         })},
      {"dumbbell", turned(80,
                          [](double v) -> Eigen::Vector2d {
                            return {std::sin(std::numbers::pi * v) *
                                        (0.02 + 0.05 * std::pow(std::cos(std::numbers::pi * v), 2)),
                                    0.2 * v};
                          })},
      {"bowl", turned({{0, 0}, {0.07, 0}, {0.1, 0.07}, {0.085, 0.07}, {0.06, 0.015}, {0, 0.015}})},
      {"torus",
       tube(80, 0.03, [](double t) { return Vector3d(0.07 * std::cos(kTurn * t), 0, 0.07 * std::sin(kTurn * t)); })},
      {"thin ring",
       tube(160, 0.006,
            [](double t) { return Vector3d(0.095 * std::cos(kTurn * t), 0, 0.095 * std::sin(kTurn * t)); })},
      {"knot", tube(240, 0.015,
                    [](double t) {
                      const double a = kTurn * t;
                      return Vector3d(0.03 * (std::sin(a) + 2 * std::sin(2 * a)),
                                      0.03 * (std::cos(a) - 2 * std::cos(2 * a)), -0.03 * std::sin(3 * a));
                    })},
      {"spaghetti", tube(600, 0.004,
                         [](double t) {
                           const double a = kTurn * t;
                           return Vector3d(0.09 * std::cos(a) * std::cos(5 * a), 0.05 * std::sin(3 * a),
                                           0.09 * std::sin(2 * a + 0.4));
                         })},
      {"shell", hollow(ball(0.1), ball(0.085))},
  };
}

void write_shape(const std::filesystem::path& path, const SurfaceMesh& surface) {
  NumberText out;
  for (const Vector3d& x : surface.positions) out.add("v ").add(x[0]).add(' ').add(x[1]).add(' ').add(x[2]).add('\n');
  for (const Triangle& t : surface.triangles)
    out.add("f ").add(t[0] + 1).add(' ').add(t[1] + 1).add(' ').add(t[2] + 1).add('\n');
  write_file(path, out.take());
}

}  // namespace fascia
