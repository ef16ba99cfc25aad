#include "sim/visual/shape_mesh.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

namespace fascia {
namespace {

TEST_CASE("the triangles of a shape enclose its volume, wound outward as their normals") {
  const auto volume = [](const ShapeMesh& mesh) {
    double enclosed = 0;
    for (const Triangle& t : mesh.triangles) {
      const Eigen::Vector3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
      enclosed += a.cross(b).dot(c) / 6;
      const Eigen::Vector3f normal = mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]],
                            wound = (b - a).cross(c - a);
      if (wound.norm() > 1e-8f) CHECK(wound.dot(normal) > 0);
    }
    return enclosed;
  };
  constexpr double kPi = 3.14159265358979;
  CHECK(volume(shape_mesh(SphereShape{{1, 2, 3}, 0.5}, 1)) == Approx(4 * kPi / 3 * 0.125).epsilon(0.02));
  CHECK(volume(shape_mesh(CapsuleShape{{0, 0, 0}, {0, 0, 2}, 0.5}, 1)) ==
        Approx(4 * kPi / 3 * 0.125 + kPi * 0.25 * 2).epsilon(0.02));
  CHECK(volume(shape_mesh(CylinderShape{{0, 1, 0}, {3, 1, 0}, 0.5}, 1)) == Approx(kPi * 0.25 * 3).epsilon(0.01));
  // Rounded to half a ball, a rod of 2 and another half.
  CHECK(volume(shape_mesh(CylinderShape{{0, 1, 0}, {3, 1, 0}, 0.5, 0.5}, 1)) ==
        Approx(4 * kPi / 3 * 0.125 + kPi * 0.25 * 2).epsilon(0.02));
  CHECK(volume(shape_mesh(BoxShape{{1, 0, 0}, {0.1, 0.2, 0.3}, 0}, 1)) == Approx(0.048).epsilon(1e-5));
  const ShapeMesh plane = shape_mesh(PlaneShape{{0, 1, 0}, {0, 2, 0}}, 5);
  for (const Eigen::Vector3f& x : plane.positions) CHECK(x.y() == Approx(1));
  for (const Eigen::Vector3f& n : plane.normals) CHECK(n.y() == Approx(1));
}

}  // namespace
}  // namespace fascia
