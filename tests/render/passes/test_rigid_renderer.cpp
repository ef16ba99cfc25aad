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

// A square of this middle between the ball at the origin and the light.
RigidSurface shade(const Vector3d& light, const Vector3d& middle) {
  RigidSurface surface;
  const Vector3d side = light.unitOrthogonal(), other = light.cross(side);
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    surface.positions.emplace_back() << (middle + 0.25 * (s * side + t * other)).cast<float>(), 0;
    surface.normals.emplace_back() << light.cast<float>(), 0;
  }
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  return surface;
}

// A ball of radius 1, seen beside the light, so that only shadows of shades fall on the pixel that faces the light.
struct LitBall {
  test::Scene scene{test::sphere({0, 0, 0}, 1, 24)};
  Vector3d light;
  Eigen::Vector2d at;

  LitBall() {
    scene.look.ground = false;
    scene.look.shadow = true;
    FrameUniforms frame{};
    ShadowMap::aim(scene.look, frame);
    light = frame.light.head<3>().cast<double>().normalized();
    scene.camera.eye = 4 * (light + Vector3d(0, 0, 1)).normalized();
    at = scene.pixel_of(light);
  }
};

TEST_CASE("rigid things shade the tissue below them") {
  const auto context = test::each_context();
  LitBall ball;
  const double lit = test::color_at(ball.scene.draw(), ball.at).sum();
  ball.scene.rigid = shade(ball.light, 1.3 * ball.light);
  const double shaded = test::color_at(ball.scene.draw(), ball.at).sum();
  CAPTURE(lit, shaded);
  CHECK(shaded < 0.9 * lit);
}

TEST_CASE("a shadow map serves for more pictures until rigid things move far") {
  const auto context = test::each_context();
  LitBall ball;
  test::Scene& scene = ball.scene;
  scene.look.quality.shadow_every = 100;
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  SceneRenderer renderer(programs, scene.shape.triangles, static_cast<std::uint32_t>(scene.shape.positions.size()), {},
                         scene.shape.positions, {});
  renderer.set_paints(scene.paints);
  const gl::Buffer positions = scene.shape.upload();
  const Framebuffer target(scene.width, scene.height, 1);
  const auto drawn = [&](const Vector3d& middle) {
    renderer.set_rigid(shade(ball.light, middle));
    renderer.draw({&positions}, scene.camera, scene.look, {}, target);
    target.resolve();
    return test::color_at(target.read(), ball.at).sum();
  };
  // The edge of the shade, 0.25 from its middle, goes over the pixel.
  const Vector3d aside = ball.light.unitOrthogonal(), before = 1.3 * ball.light + 0.258 * aside,
                 after = 1.3 * ball.light + 0.243 * aside;
  const double lit = drawn(before), kept = drawn(after), shaded = drawn(1.3 * ball.light);
  scene.rigid = shade(ball.light, after);
  const double with_new_map = test::color_at(scene.draw(), ball.at).sum();
  CAPTURE(lit, kept, with_new_map, shaded);
  CHECK(kept == Approx(lit).epsilon(0.01));
  CHECK(with_new_map < 0.95 * lit);
  CHECK(shaded < 0.9 * lit);
}

}  // namespace
}  // namespace fascia
