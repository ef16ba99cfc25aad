#include "sim/tool/shape_distance.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<ToolShape> shapes() {
  return {SphereShape{{0.1, -0.2, 0.3}, 0.4},
          CapsuleShape{{0, 0, 0}, {0.3, 0.5, -0.2}, 0.2},
          BoxShape{{0.1, 0, 0}, {0.3, 0.2, 0.4}, 0},
          BoxShape{{0.1, 0, 0}, {0.3, 0.2, 0.4}, 0.1},
          PlaneShape{{0, 0.1, 0}, {1, 2, 0.5}},
          CylinderShape{{0, -0.2, 0}, {0.2, 0.3, 0.1}, 0.25, 0},
          CylinderShape{{0, -0.2, 0}, {0.2, 0.3, 0.1}, 0.25, 0.1}};
}

TEST_CASE("normals and curvatures are the derivatives of the distance", "[tool]") {
  test::Random random(3);
  for (std::size_t s = 0; s < shapes().size(); ++s)
    for (int sample = 0; sample < 200; ++sample) {
      const ToolShape shape = shapes()[s];
      const Vector3d x = random.vector();
      const ShapeDistance at = distance_to(shape, x);
      constexpr double kStep = 1e-6;
      Vector3d normal;
      Matrix3d curvature;
      double jump = 0;
      for (int k = 0; k < 3; ++k) {
        const ShapeDistance more = distance_to(shape, x + kStep * Vector3d::Unit(k)),
                            less = distance_to(shape, x - kStep * Vector3d::Unit(k));
        normal[k] = (more.distance - less.distance) / (2 * kStep);
        curvature.col(k) = (more.normal - less.normal) / (2 * kStep);
        jump = std::max({jump, (more.normal - at.normal).norm(), (more.curvature - less.curvature).norm()});
      }
      if (jump > 1e-3) continue;  // at an edge between two parts of the shape, or inside at the middle between faces
      CAPTURE(s, x.transpose(), at.distance, at.normal.transpose(), normal.transpose(), at.curvature, curvature);
      CHECK(at.normal.norm() == Approx(1));
      CHECK((at.normal - normal).norm() < 1e-6);
      CHECK((at.curvature - curvature).norm() < 1e-5);
    }
}

TEST_CASE("a point of a shape's surface lies at the stated distance", "[tool]") {
  test::Random random(4);
  for (std::size_t s = 0; s < shapes().size(); ++s)
    for (int sample = 0; sample < 100; ++sample) {
      const Vector3d x = 2 * random.vector();
      const ShapeDistance at = distance_to(shapes()[s], x);
      if (at.distance <= 0) continue;
      const Vector3d foot = x - at.distance * at.normal;
      CAPTURE(s, x.transpose(), at.distance);
      CHECK(distance_to(shapes()[s], foot).distance == Approx(0).margin(1e-12));
      for (int other = 0; other < 20; ++other) {  // no point of the shape is nearer
        const Vector3d near = x + 0.999 * at.distance * random.vector().normalized();
        CHECK(distance_to(shapes()[s], near).distance > 0);
      }
    }
}

TEST_CASE("places near the edges of boxes and the rims of cylinders are told", "[tool]") {
  const BoxShape box{{0.1, 0, 0}, {0.3, 0.2, 0.4}, 0.01};
  CHECK(sharpest_edge(box) == 0.01);
  CHECK(near_edge(box, {0.39, 0.19, 0}, 0.02));
  CHECK(near_edge(box, {0.41, 0.19, 0}, 0.02));
  CHECK(near_edge(box, {0.1, 0.21, -0.39}, 0.02));
  CHECK_FALSE(near_edge(box, {0.37, 0.21, 0}, 0.02));
  CHECK_FALSE(near_edge(box, {0.1, 0, 0}, 0.02));
  const CylinderShape cylinder{{0, 0, 1}, {0, 0.5, 1}, 0.2};
  CHECK(sharpest_edge(cylinder) == 0);
  CHECK(sharpest_edge(CylinderShape{{0, 0, 1}, {0, 0.5, 1}, 0.2, 0.03}) == 0.03);
  CHECK(near_edge(cylinder, {0.13, 0.49, 1.13}, 0.02));  // 0.184 m from the axis
  CHECK(near_edge(cylinder, {0, 0.01, 0.79}, 0.02));
  CHECK_FALSE(near_edge(cylinder, {0, 0.25, 0.79}, 0.02));
  CHECK_FALSE(near_edge(cylinder, {0, 0.01, 1}, 0.02));
  CHECK_FALSE(near_edge(SphereShape{{0, 0, 0}, 0.1}, {0.1, 0, 0}, 0.05));
  CHECK(std::isinf(sharpest_edge(PlaneShape{{0, 0, 0}, {0, 1, 0}})));
}

TEST_CASE("shapes lie within their balls", "[tool]") {
  test::Random random(5);
  for (const ToolShape& shape : shapes()) {
    if (std::holds_alternative<PlaneShape>(shape)) {
      CHECK(bounding_radius(shape) == std::numeric_limits<double>::infinity());
      continue;
    }
    for (int sample = 0; sample < 200; ++sample) {
      const Vector3d x = random.vector();
      if (distance_to(shape, x).distance > 0) continue;
      CHECK((x - middle_of(shape)).norm() <= bounding_radius(shape) + 1e-12);
    }
    CHECK(finest_radius(shape) <= bounding_radius(shape));
  }
}

}  // namespace
}  // namespace fascia
