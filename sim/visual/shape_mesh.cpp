#include "sim/visual/shape_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "sim/tool/solid_mesh.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr int kAround = 48;       // corners of a circle
constexpr int kRings = 12;        // of a half sphere
constexpr double kSmooth = 0.77;  // cosine of the largest angle of an edge that is drawn round

// A point of a profile that turns about an axis: along the axis, away from it, and its normal in the same terms.
struct ProfilePoint {
  double along, away, normal_along, normal_away;
};

class Builder {
 public:
  void turn(const std::vector<ProfilePoint>& profile, const Vector3d& origin, const Vector3d& axis) {
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const ProfilePoint& p : profile)
      for (int k = 0; k < kAround; ++k) {
        const double angle = 2 * std::numbers::pi * k / kAround;
        const Vector3d away = std::cos(angle) * u + std::sin(angle) * v;
        add(origin + p.along * axis + p.away * away, p.normal_along * axis + p.normal_away * away);
      }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring)
      for (std::uint32_t k = 0; k < kAround; ++k) {
        const std::uint32_t a = first + ring * kAround + k, b = first + ring * kAround + (k + 1) % kAround;
        mesh_.triangles.push_back({a, b, b + kAround});
        mesh_.triangles.push_back({a, b + kAround, a + kAround});
      }
  }

  void add_quad(const Vector3d& center, const Vector3d& half_u, const Vector3d& half_v) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const Vector3d normal = half_u.cross(half_v).normalized();
    for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      add(center + s * half_u + t * half_v, normal);
    mesh_.triangles.push_back({first, first + 1, first + 2});
    mesh_.triangles.push_back({first, first + 2, first + 3});
  }

  // A vertex for every corner, whose normal is that of the triangles around it, without those beyond a sharp edge.
  void add_solid(const SolidMesh& solid) {
    std::vector<Vector3d> normals;  // twice the area of each triangle
    std::vector<std::vector<std::size_t>> around(solid.positions.size());
    for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
      const Triangle& corners = solid.triangles[t];
      const Vector3d& a = solid.positions[corners[0]];
      normals.push_back((solid.positions[corners[1]] - a).cross(solid.positions[corners[2]] - a));
      for (const std::uint32_t v : corners) around[v].push_back(t);
    }
    for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
      const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
      for (const std::uint32_t v : solid.triangles[t]) {
        Vector3d normal(0, 0, 0);
        for (const std::size_t other : around[v])
          if (normals[other].dot(normals[t]) > kSmooth * normals[other].norm() * normals[t].norm())
            normal += normals[other];
        add(solid.positions[v], normal.normalized());
      }
      mesh_.triangles.push_back({first, first + 1, first + 2});
    }
  }

  ShapeMesh take() { return std::move(mesh_); }

 private:
  void add(const Vector3d& position, const Vector3d& normal) {
    mesh_.positions.push_back(position.cast<float>());
    mesh_.normals.push_back(normal.cast<float>());
  }
  ShapeMesh mesh_;
};

// From one pole to the other: half spheres around two points of the axis.
std::vector<ProfilePoint> capsule_profile(double length, double radius) {
  std::vector<ProfilePoint> profile;
  for (const bool upper : {false, true})
    for (int ring = 0; ring <= kRings; ++ring) {
      const double angle = (upper ? 0 : -1) * std::numbers::pi / 2 + std::numbers::pi / 2 * ring / kRings;
      profile.push_back({(upper ? length : 0) + radius * std::sin(angle), radius * std::cos(angle), std::sin(angle),
                         std::cos(angle)});
    }
  return profile;
}

// From the middle of one end to that of the other. Without a rounding the edges are drawn sharp.
std::vector<ProfilePoint> cylinder_profile(double length, double radius, double round) {
  std::vector<ProfilePoint> profile = {{0, 0, -1, 0}};
  for (const bool upper : {false, true})
    for (int ring = 0; ring <= kRings; ring += round > 0 ? 1 : kRings) {
      const double angle = (upper ? 0 : -1) * std::numbers::pi / 2 + std::numbers::pi / 2 * ring / kRings;
      const double along = std::sin(angle), away = std::cos(angle);
      profile.push_back({(upper ? length - round : round) + round * along, radius - round + round * away, along, away});
    }
  profile.push_back({length, 0, 1, 0});
  return profile;
}

struct Maker {
  double reach;

  ShapeMesh operator()(const SphereShape& s) const {
    Builder builder;
    builder.turn(capsule_profile(0, s.radius), s.center, Vector3d::UnitY());
    return builder.take();
  }
  ShapeMesh operator()(const CapsuleShape& s) const {
    Builder builder;
    builder.turn(capsule_profile((s.to - s.from).norm(), s.radius), s.from, (s.to - s.from).normalized());
    return builder.take();
  }
  ShapeMesh operator()(const CylinderShape& s) const {
    const double length = (s.to - s.from).norm();
    Builder builder;
    builder.turn(cylinder_profile(length, s.radius, s.round), s.from, (s.to - s.from).normalized());
    return builder.take();
  }
  // Without its rounding: edges are drawn sharp.
  ShapeMesh operator()(const BoxShape& s) const {
    Builder builder;
    for (int k = 0; k < 3; ++k)
      for (const double side : {-1.0, 1.0}) {
        const Vector3d out = side * s.half_size[k] * Vector3d::Unit(k),
                       u = s.half_size[(k + 1) % 3] * Vector3d::Unit((k + 1) % 3),
                       v = side * s.half_size[(k + 2) % 3] * Vector3d::Unit((k + 2) % 3);
        builder.add_quad(s.center + out, u, v);
      }
    return builder.take();
  }
  ShapeMesh operator()(const MeshShape& s) const {
    Builder builder;
    builder.add_solid(*s.solid);
    return builder.take();
  }
  ShapeMesh operator()(const PlaneShape& s) const {
    Builder builder;
    builder.turn({{0, reach, 1, 0}, {0, 0, 1, 0}}, s.point, s.normal.normalized());
    return builder.take();
  }
};

}  // namespace

ShapeMesh shape_mesh(const ToolShape& shape, double reach) { return std::visit(Maker{reach}, shape); }

}  // namespace fascia
