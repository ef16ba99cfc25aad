#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "render/view/camera.h"

using Eigen::Vector3d;
using fascia::Camera;

namespace {

/// Normalized device coordinates of a point.
Vector3d project(const Camera& camera, const Vector3d& point, double aspect, double radius) {
  const Eigen::Matrix4d matrix = (camera.projection(aspect, radius) * camera.view()).cast<double>();
  return (matrix * point.homogeneous()).hnormalized();
}

Camera random_camera(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  Camera camera;
  camera.target = scale * vector();
  camera.eye = camera.target + scale * (vector() + Vector3d(0, 0, 3));
  camera.up = (Vector3d(0, 1, 0) + 0.3 * vector()).normalized();
  camera.fov_deg = 45 + 20 * uniform(random);
  return camera;
}

}  // namespace

TEST_CASE("camera: the ray under a pixel projects back to that pixel") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const double scale : {1e-3, 1.0, 100.0}) {
    for (const auto& [width, height] : {std::pair(1280, 720), std::pair(480, 720)})
      for (int i = 0; i < 50; ++i) {
        Camera camera = random_camera(random, scale);
        if (i % 2) camera.middle = {uniform(random) - 0.5, uniform(random) - 0.5};
        const double x = width * uniform(random), y = height * uniform(random);
        const fascia::Ray ray = camera.ray(x, y, width, height);
        CHECK(ray.direction.norm() == Approx(1).epsilon(1e-12));
        const Vector3d point = ray.origin + ray.direction * scale * (1 + 4 * uniform(random));
        const Vector3d ndc = project(camera, point, double(width) / height, scale);
        CAPTURE(scale, x, y, ndc.transpose());
        // The matrices are float (6e-8) and the eye is up to 5 scene sizes from the origin: 1e-5 of the picture is 0.01
        // pixel.
        CHECK(std::abs((ndc.x() + 1) / 2 * width - x) < 0.02);
        CHECK(std::abs((1 - ndc.y()) / 2 * height - y) < 0.02);
      }
  }
}

TEST_CASE("camera: the ray through the middle goes to the target") {
  const Camera camera;
  const fascia::Ray ray = camera.ray(320, 180, 640, 360);
  CHECK((ray.direction - camera.forward()).norm() < 1e-12);
  CHECK((ray.origin - camera.eye).norm() == 0);
}

TEST_CASE("camera: the target is at the requested middle") {
  Camera camera;
  camera.middle = {0.25, -0.5};
  CHECK((project(camera, camera.target, 640.0 / 360, 1).head<2>() - camera.middle).norm() < 1e-6);
  CHECK((camera.ray(400, 270, 640, 360).direction - camera.forward()).norm() < 1e-12);
}

TEST_CASE("camera: an orbit keeps its distance and never passes the pole") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (const Vector3d& up : {Vector3d(0, 1, 0), Vector3d(0, 0, 1), Vector3d(1, 2, -1).normalized()}) {
    Camera camera;
    camera.up = up;
    camera.eye = Vector3d(1, 2, 3);
    const double distance = (camera.eye - camera.target).norm();
    for (int i = 0; i < 200; ++i) {
      camera.orbit(uniform(random), uniform(random));
      const double elevation = std::asin((camera.eye - camera.target).dot(up) / distance);
      INFO("elevation " << elevation);
      REQUIRE(std::abs(elevation) <= 89.001 * std::numbers::pi / 180);
      REQUIRE((camera.eye - camera.target).norm() == Approx(distance).epsilon(1e-12));
      REQUIRE(camera.view().col(1).head<3>().allFinite());
    }
    // Pushed against the pole the camera stays there; a rotation still has its full angle.
    camera.orbit(0, 10);
    const Vector3d before = camera.eye;
    camera.orbit(0, 10);
    CHECK((camera.eye - before).norm() < 1e-9);
    camera.orbit(std::numbers::pi, 0);
    const Vector3d across = (camera.eye - before) - up * (camera.eye - before).dot(up);
    CHECK(across.norm() == Approx(2 * distance * std::cos(89 * std::numbers::pi / 180)).epsilon(1e-6));
  }
}

TEST_CASE("camera: the scene follows the mouse") {
  Camera camera;
  camera.eye = {0, 0, 2};
  const Vector3d front(0, 0, 0.5);
  const Vector3d before = project(camera, front, 1, 1);
  Camera turned = camera;
  turned.orbit(0.1, 0);
  CHECK(project(turned, front, 1, 1).x() > before.x());
  turned = camera;
  turned.orbit(0, 0.1);
  CHECK(project(turned, front, 1, 1).y() < before.y());
  // A pan by a tenth of the shorter side moves the target's image by the same amount.
  Camera panned = camera;
  panned.pan(0.1, 0.2);
  const Vector3d target = project(panned, camera.target, 1, 1);
  CHECK(target.x() == Approx(0.2).margin(1e-5));
  CHECK(target.y() == Approx(-0.4).margin(1e-5));
  camera.zoom(0.5);
  CHECK((camera.eye - camera.target).norm() == Approx(1));
}

TEST_CASE("camera: the field of view is the shorter side's") {
  Camera camera;
  camera.eye = {0, 0, 2};
  camera.fov_deg = 90;
  // At 90 degrees a point whose lateral offset equals its depth is on the edge.
  CHECK(project(camera, {0, 2, 0}, 1.5, 1).y() == Approx(1).epsilon(1e-6));
  CHECK(project(camera, {2, 0, 0}, 1.5, 1).x() == Approx(1 / 1.5).epsilon(1e-6));
  CHECK(project(camera, {2, 0, 0}, 0.5, 1).x() == Approx(1).epsilon(1e-6));
  CHECK(project(camera, {0, 2, 0}, 0.5, 1).y() == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("camera: fit fills a part of the picture around its middle") {
  std::mt19937 random(12);
  for (const double aspect : {0.6, 16.0 / 9}) {
    Camera camera = random_camera(random, 1);
    camera.middle = {0.4, 0};
    camera.fit({0, 0, 0}, {1, 0.2, 0.5}, aspect, {0.6, 1});
    Eigen::AlignedBox2d seen;
    for (int corner = 0; corner < 8; ++corner)
      seen.extend(Eigen::Vector2d(
          project(camera, {corner & 1 ? 1.0 : 0.0, corner & 2 ? 0.2 : 0.0, corner & 4 ? 0.5 : 0.0}, aspect, 1)
              .head<2>()));
    CAPTURE(aspect, seen.min().transpose(), seen.max().transpose());
    CHECK(seen.min().x() > 0.4 - 0.6 * 0.8801);
    CHECK(seen.max().x() < 0.4 + 0.6 * 0.8801);
    CHECK(seen.min().y() > -0.8801);
    CHECK(seen.max().y() < 0.8801);
    CHECK(std::max(seen.sizes().x() / 0.6, seen.sizes().y()) == Approx(2 * 0.88).margin(1e-3));
  }
}

TEST_CASE("camera: fit fills the picture and keeps the direction of view") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  for (const double scale : {1e-3, 1.0, 100.0}) {
    for (const double aspect : {0.6, 1.0, 16.0 / 9}) {
      Camera camera = random_camera(random, scale);
      const Vector3d forward = camera.forward();
      const Vector3d low = scale * Vector3d(uniform(random), uniform(random), uniform(random));
      const Vector3d high = low + scale * Vector3d(uniform(random), uniform(random), uniform(random));
      camera.fit(low, high, aspect);
      CHECK((camera.forward() - forward).norm() < 1e-9);
      Eigen::AlignedBox2d seen;
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3d point(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                             corner & 4 ? high.z() : low.z());
        const Vector3d ndc = project(camera, point, aspect, scale);
        CHECK(std::abs(ndc.z()) < 1);
        seen.extend(Eigen::Vector2d(ndc.head<2>()));
      }
      CAPTURE(scale, aspect, seen.min().transpose(), seen.max().transpose());
      // The larger direction fills the 0.88 that fit() uses, on both sides; the smaller one fills at most as much.
      CHECK(seen.sizes().maxCoeff() == Approx(2 * 0.88).margin(1e-3));
      CHECK(seen.min().minCoeff() > -0.8801);
      CHECK(seen.max().maxCoeff() < 0.8801);
    }
  }
}

TEST_CASE("camera: frame shows the whole box from the front right above, for any up") {
  for (const Vector3d& up : {Vector3d(0, 1, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)}) {
    Camera camera;
    camera.up = up;
    const Vector3d low(-3, 1, 2), high(-1, 2, 5);
    camera.frame(low, high);
    CHECK((camera.eye - camera.target).dot(up) > 0);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d point(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                           corner & 4 ? high.z() : low.z());
      CHECK(project(camera, point, 1, 2).cwiseAbs().maxCoeff() < 1);
    }
  }
  Camera camera;
  camera.frame({0, 0, 0}, {1, 1, 1});
  CHECK(camera.forward().z() < -0.5);
  CHECK(camera.forward().x() < 0);
  // A single point must not cause a division by zero.
  camera.frame({2, 2, 2}, {2, 2, 2});
  CHECK(camera.eye.allFinite());
  CHECK((camera.eye - camera.target).norm() > 0);
}

TEST_CASE("camera: pixel_size is the distance between neighboring pixels' rays at that depth") {
  Camera camera;
  camera.eye = {0.2, 0.5, 1.5};
  const Vector3d point(0.1, -0.2, 0.3);
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(300, 480)}) {
    const double depth = (point - camera.eye).dot(camera.forward());
    const auto at_depth = [&, width = width, height = height](double x, double y) {
      const fascia::Ray ray = camera.ray(x, y, width, height);
      return Vector3d(ray.origin + ray.direction * depth / ray.direction.dot(camera.forward()));
    };
    CHECK((at_depth(11, 20) - at_depth(10, 20)).norm() ==
          Approx(camera.pixel_size(point, width, height)).epsilon(1e-9));
    CHECK((at_depth(10, 21) - at_depth(10, 20)).norm() ==
          Approx(camera.pixel_size(point, width, height)).epsilon(1e-9));
  }
}

TEST_CASE("camera: near and far planes include the scene and the ground at every zoom") {
  for (const double radius : {5e-4, 1.0, 100.0}) {
    for (const double away : {0.05, 0.5, 3.0, 15.0}) {
      Camera camera;
      camera.target = {radius, 0, 0};
      camera.eye = camera.target + away * radius * Vector3d(0, 0.6, 0.8);
      CAPTURE(radius, away);
      // The range includes ten radii beyond the target, and every point farther from the eye than a twentieth of the
      // target's distance.
      CHECK(project(camera, camera.target + 10 * radius * camera.forward(), 1, radius).z() < 1);
      CHECK(project(camera, camera.eye + 0.05 * away * radius * camera.forward(), 1, radius).z() > -1);
      CHECK(camera.projection(1, radius).allFinite());
    }
  }
}
