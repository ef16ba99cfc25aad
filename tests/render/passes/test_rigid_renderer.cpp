#include "render/passes/rigid_renderer.h"

#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// A square across the view at this distance before the middle of the scene.
RigidSurface square(const test::Scene& scene, double before, double half) {
  const Vector3d forward = scene.camera.forward(), right = forward.cross(scene.camera.up).normalized(),
                 up = right.cross(forward), middle = scene.look.center - before * forward;
  RigidSurface surface;
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    surface.positions.emplace_back() << (middle + s * half * right + t * half * up).cast<float>(), 0;
    surface.normals.emplace_back() << (-forward).cast<float>(), 0;
  }
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  return surface;
}

double colorfulness(const Vector3d& color) { return color.maxCoeff() - color.minCoeff(); }

TEST_CASE("rigid things are of gray metal, and hide and are hidden by depth") {
  const auto context = test::each_context();
  test::Scene scene(test::sphere({0, 0, 0}, 1, 24));
  scene.look.ground = false;
  const Eigen::Vector2d at = scene.pixel_of(scene.look.center);
  const Vector3d tissue = test::color_at(scene.draw(), at.x(), at.y());
  scene.rigid = square(scene, 1.5, 0.4);
  const Vector3d before = test::color_at(scene.draw(), at.x(), at.y());
  scene.rigid = square(scene, -1.5, 0.4);
  const Vector3d behind = test::color_at(scene.draw(), at.x(), at.y());
  CAPTURE(tissue.transpose(), before.transpose(), behind.transpose());
  CHECK(colorfulness(tissue) > 0.2);
  CHECK(colorfulness(before) < 0.1);
  CHECK((behind - tissue).norm() < 0.1);
}

TEST_CASE("rigid things shade the tissue below them") {
  const auto context = test::each_context();
  test::Scene scene(test::sphere({0, 0, 0}, 1, 24));
  scene.look.ground = false;
  scene.look.shadow = true;
  // Between the light and the part of the ball that faces it.
  FrameUniforms frame{};
  ShadowMap::aim(scene.look, frame);
  const Vector3d light = frame.light.head<3>().cast<double>().normalized();
  scene.camera.eye = 4 * (light + Vector3d(0, 0, 1)).normalized();
  const Eigen::Vector2d at = scene.pixel_of(light);
  const double lit = test::color_at(scene.draw(), at.x(), at.y()).sum();
  const Vector3d side = light.unitOrthogonal(), other = light.cross(side);
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    scene.rigid.positions.emplace_back() << (1.3 * light + 0.25 * (s * side + t * other)).cast<float>(), 0;
    scene.rigid.normals.emplace_back() << light.cast<float>(), 0;
  }
  // Only its shadow falls on the pixel: a camera beside the light looks past it.
  scene.rigid.triangles = {{0, 1, 2}, {0, 2, 3}};
  const double shaded = test::color_at(scene.draw(), at.x(), at.y()).sum();
  CAPTURE(lit, shaded);
  CHECK(shaded < 0.9 * lit);
}

}  // namespace
}  // namespace fascia
