// The point under a pixel of a picture, on a sphere whose points are known.
#include "render/target/depth_probe.h"

#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::Scene;

/// Draws the scene and returns the result of the probe at a pixel.
std::optional<DepthProbe::Spot> spot_at(const Scene& scene, const Eigen::Vector2i& pixel) {
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  SceneRenderer renderer(programs, scene.shape.triangles, static_cast<std::uint32_t>(scene.shape.positions.size()), {},
                         scene.shape.positions, {});
  const gl::Buffer positions = scene.shape.upload();
  const Framebuffer target(scene.width, scene.height, scene.samples);
  renderer.draw({&positions}, scene.camera, scene.look, {}, target);
  const double aspect = static_cast<double>(scene.width) / scene.height;
  DepthProbe probe;
  std::optional<DepthProbe::Spot> spot;
  CHECK_FALSE(probe.take(spot));  // no request was made
  probe.request(target, pixel.x(), pixel.y(),
                (scene.camera.projection(aspect, scene.look.radius) * scene.camera.view()).cast<double>());
  CHECK(probe.pending());
  gl::Finish();
  REQUIRE(probe.take(spot));
  CHECK_FALSE(probe.pending());
  CHECK(gl::GetError() == GL_NO_ERROR);
  return spot;
}

}  // namespace

TEST_CASE("render: the point and the normal under a pixel are those of the sphere that is drawn there") {
  const auto context = test::each_context();
  const Vector3d center(0.1, 0.7, -0.2);
  Scene scene(test::sphere(center, 0.5, 80));
  scene.look.ground = scene.look.shadow = false;
  scene.samples = GENERATE(1, 4);
  CAPTURE(scene.samples);
  for (const auto& [x, y] : {std::pair{160, 120}, {140, 100}, {185, 130}}) {
    const std::optional<DepthProbe::Spot> spot = spot_at(scene, {x, y});
    CAPTURE(x, y);
    REQUIRE(spot);
    const Vector3d outward = (spot->point - center).normalized();
    CAPTURE(spot->point, spot->normal, outward);
    CHECK((spot->point - center).norm() == Approx(0.5).epsilon(0.01));
    CHECK((scene.pixel_of(spot->point) - Eigen::Vector2d(x + 0.5, y + 0.5)).norm() < 0.1);
    CHECK(spot->normal.norm() == Approx(1));
    CHECK(spot->normal.dot(outward) > 0.98);  // the normal of a triangle
    CHECK(spot->normal.dot(scene.camera.forward()) < 0);
  }
  CHECK_FALSE(spot_at(scene, {0, 0}));  // beside the body, and at the picture's corners
  CHECK_FALSE(spot_at(scene, {319, 239}));
}

}  // namespace fascia
