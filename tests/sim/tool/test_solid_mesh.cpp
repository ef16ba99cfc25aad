// Distances of closed surfaces on grids, against the shapes that they are.
#include "sim/tool/solid_mesh.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/surfaces.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("a mesh of a ball is as far as the ball, in its grid and beyond", "[tool]") {
  const SolidMesh solid = solid_of(test::make_sphere(48, 96, 3, {10, 0, 0}), 0.01, "ball.obj");
  const SphereShape ball{{0.1, 0, 0}, 0.03};
  CHECK(solid.thickness == Approx(2 * 0.03 / 3).epsilon(2e-3));
  CHECK(*std::max_element(solid.count.begin(), solid.count.end()) == 64 + 7);
  test::Random random(1);
  double worst = 0, worst_normal = 0;
  for (int sample = 0; sample < 500; ++sample) {
    const Vector3d x = ball.center + 0.04 * random.vector();
    const ShapeDistance at = distance_to(solid, x), exact = distance_to(ToolShape(ball), x);
    if (exact.distance < -0.02) continue;  // near the center
    CHECK(at.distance < exact.distance + 0.1 * solid.spacing);
    if (exact.distance < 2 * solid.spacing)  // the grid may end there, with a lower bound beyond
      worst = std::max(worst, std::abs(at.distance - exact.distance));
    if (exact.distance < 0.002) worst_normal = std::max(worst_normal, (at.normal - exact.normal).norm());
  }
  CAPTURE(worst, worst_normal, solid.spacing);
  CHECK(worst < 0.1 * solid.spacing);
  CHECK(worst_normal < 0.03);
  const ShapeDistance far = distance_to(solid, {0.1, 1, 0});
  CHECK(far.distance <= 0.97 + 1e-9);
  CHECK(far.distance > 0.93);
}

TEST_CASE("gradients and curvatures of a mesh are those of its distance", "[tool]") {
  const SolidMesh solid = solid_of(test::make_box_surface({1, 0.5, 0.7}), 0.1, "box.obj");
  const ToolShape shape = BoxShape{{0.05, 0.025, 0.035}, {0.05, 0.025, 0.035}, 0};
  test::Random random(2);
  double worst = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const Vector3d x = Vector3d(0.05, 0.025, 0.035) + 0.06 * random.vector();
    const ShapeDistance at = distance_to(solid, x);
    constexpr double kStep = 1e-7;
    Vector3d slope;
    Matrix3d bend;
    for (int k = 0; k < 3; ++k) {
      const ShapeDistance more = distance_to(solid, x + kStep * Vector3d::Unit(k)),
                          less = distance_to(solid, x - kStep * Vector3d::Unit(k));
      slope[k] = (more.distance - less.distance) / (2 * kStep);
      bend.col(k) = (more.normal - less.normal) / (2 * kStep);
    }
    CAPTURE(x.transpose(), at.distance, at.normal.transpose(), slope.transpose(), at.curvature, bend);
    CHECK((at.normal - slope).norm() < 1e-6);
    const double exact = distance_to(shape, x).distance;
    CHECK(at.distance < exact + solid.spacing);
    if (exact > 2 * solid.spacing) continue;  // the grid may end there, with a lower bound beyond
    CHECK((at.curvature - bend).norm() < 1e-4 / solid.spacing);
    worst = std::max(worst, std::abs(at.distance - exact));
  }
  CAPTURE(worst, solid.spacing);
  CHECK(worst < 1.0 * solid.spacing);
}

TEST_CASE("the distance for reports is exact beyond the grid", "[tool]") {
  const Vector3d size(0.1, 0.05, 0.07);
  const SolidMesh solid = solid_of(test::make_box_surface(size), 1, "box.obj");
  const ToolShape box = BoxShape{size / 2, size / 2, 0};
  test::Random random(3);
  double worst_near = 0, worst_far = 0, shortest = 1;
  for (int sample = 0; sample < 2000; ++sample) {
    const Vector3d x = size / 2 + (sample % 2 == 0 ? 0.3 : 0.06) * random.vector();
    const double exact = distance_to(box, x).distance, gap = gap_to(solid, x);
    if (exact < 0) continue;
    double& worst = exact < 4 * std::sqrt(3) * solid.spacing ? worst_near : worst_far;  // the grid's corners
    worst = std::max(worst, std::abs(gap - exact));
    shortest = std::min(shortest, distance_to(solid, x).distance / exact);
  }
  CAPTURE(1e6 * worst_near, 1e12 * worst_far, shortest);
  CHECK(worst_near < solid.spacing);
  CHECK(worst_far < 1e-12);
  CHECK(shortest < 0.8);  // what presses has a lower bound there
  // From the surface outward there is no jump beyond the grid's own error.
  for (const Vector3d& along : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(1, 2, 0.5).normalized().eval()})
    for (int step = 0; step <= 60; ++step) {
      const Vector3d x = size / 2 + (1 + 0.1 * step) * 0.5 * size.x() * along;
      const double exact = distance_to(box, x).distance;
      if (exact < 0) continue;
      CAPTURE(along.transpose(), exact, gap_to(solid, x));
      CHECK(std::abs(gap_to(solid, x) - exact) < (exact < 4 * std::sqrt(3) * solid.spacing ? solid.spacing : 1e-12));
    }
}

TEST_CASE("a thin plate has a finer grid, and open surfaces are refused in one line", "[tool]") {
  const SolidMesh plate = solid_of(test::make_box_surface({0.1, 0.004, 0.05}), 1, "plate.obj");
  CHECK(plate.spacing == Approx(0.1 / 104).epsilon(0.2));
  CHECK(plate.count[0] > 90);
  CHECK(distance_to(plate, {0.05, 0.002, 0.02}).distance == Approx(-0.002).epsilon(0.2));
  SurfaceMesh open = test::make_sphere(12, 12, 1);
  open.triangles.pop_back();
  CHECK_THROWS_WITH(solid_of(open, 1, "open.obj"),
                    "open.obj: is open: 3 edges of one triangle only; expected a closed surface");
}

}  // namespace
}  // namespace fascia
