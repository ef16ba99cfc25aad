// The background of the tissue, fading into it, and ambient occlusion.
// Covers: render/passes/ambient_occlusion
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::color_at;
using test::Scene;

Vector3d corner_color(const Image& image) { return color_at(image, 1, 1); }
int alpha_at(const Image& image, double x, double y) {
  return image.rgba[4 * static_cast<std::size_t>(static_cast<int>(y) * image.width + static_cast<int>(x)) + 3];
}

}  // namespace

TEST_CASE("render: white and black backdrops have that color to the bit in empty pixels") {
  const auto context = test::each_context();
  Scene scene(test::sphere({0, 0.7, 0}, 0.5, 12));
  scene.look.ground_height = 0;
  scene.camera.zoom(2);
  scene.look.backdrop = Backdrop::white;
  CHECK(corner_color(scene.draw()) == Vector3d(1, 1, 1));
  scene.look.backdrop = Backdrop::black;
  CHECK(corner_color(scene.draw()) == Vector3d(0, 0, 0));
}

TEST_CASE("render: a transparent backdrop leaves straight colors at the body's edge and its shadow as alpha") {
  const auto context = test::each_context();
  Scene scene(test::sphere({0, 0.7, 0}, 0.5, 12));
  scene.samples = 4;
  scene.look.ground_height = 0;
  scene.camera.zoom(1.6);
  scene.look.backdrop = Backdrop::transparent;
  const Image image = scene.draw();
  CHECK(alpha_at(image, 1, 1) == 0);
  const Eigen::Vector2d middle = scene.pixel_of({0, 0.7, 0});
  CHECK(alpha_at(image, middle.x(), middle.y()) == 255);
  const Vector3d light = test::toward_light(scene.look);
  const Eigen::Vector2d foot = scene.pixel_of(Vector3d(0, 0.7, 0) - light * (0.7 / light.y()));
  const int shadow = alpha_at(image, foot.x(), foot.y());
  CAPTURE(shadow);
  CHECK((shadow > 40 && shadow < 200));
  CHECK(color_at(image, foot) == Vector3d(0, 0, 0));
  // The color of a pixel is the body's, however small the covered part is.
  scene.look.ground = false;
  const Image body = scene.draw();
  int edges = 0;
  for (int y = 0; y < body.height; ++y)
    for (int x = 0; x < body.width; ++x) {
      const int alpha = alpha_at(body, x, y);
      if (alpha < 50 || alpha > 205) continue;
      ++edges;
      const Vector3d color = color_at(body, x + 0.5, y + 0.5);
      CAPTURE(x, y, alpha, color.transpose());
      CHECK(color.x() > 0.35);  // premultiplied it would be below that at a quarter of the coverage
    }
  CHECK(edges > 50);
}

TEST_CASE("render: depth cue fades the back of a body, not its front") {
  const auto context = test::each_context();
  Scene scene(test::box({-0.3, 0, -3}, {0.3, 0.6, 3}, 4));
  scene.look.shadow = scene.look.ground = false;
  scene.camera.target = {0, 0.3, 0};
  scene.camera.eye = {2.5, 1.5, 7};
  scene.look.backdrop = Backdrop::black;
  const Image plain = scene.draw();
  scene.look.depth_cue = 0.8f;
  const Image cued = scene.draw();
  const auto kept = [&](double z) {
    const Eigen::Vector2d at = scene.pixel_of({0.3, 0.3, z});
    return color_at(cued, at).sum() / color_at(plain, at).sum();
  };
  CAPTURE(kept(2.8), kept(-2.8));
  CHECK(kept(2.8) > 0.9);
  CHECK(kept(-2.8) < 0.45);
}

TEST_CASE("render: ambient occlusion darkens a crease, but neither a plane nor a free-standing body") {
  const auto context = test::each_context();
  test::Shape shape;  // a floor and a wall behind it
  shape.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, {-1, 2, -1}, {1, 2, -1}};
  shape.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 5}, {3, 5, 4}};
  Scene scene(shape);
  scene.look.shadow = scene.look.ground = false;
  scene.camera.eye = {0.6, 2.2, 4};
  scene.camera.target = {0, 0.6, 0};
  const Image plain = scene.draw();
  scene.look.ambient_occlusion = 1;
  const Image occluded = scene.draw();
  const auto kept = [&](const Vector3d& place) {
    const Eigen::Vector2d at = scene.pixel_of(place);
    return color_at(occluded, at).sum() / color_at(plain, at).sum();
  };
  CAPTURE(kept({0, 0, 0.3}), kept({0, 1.3, -1}), kept({0, 0, -0.95}), kept({0, 0.05, -1}));
  CHECK(kept({0, 0, 0.3}) > 0.97);
  CHECK(kept({0, 1.3, -1}) > 0.97);
  CHECK(kept({0, 0, -0.95}) < 0.8);
  CHECK(kept({0, 0.05, -1}) < 0.8);
  CHECK(corner_color(occluded) == corner_color(plain));  // there is nothing behind

  INFO("wherever in the picture it stands");
  const Vector3d places[] = {{0, 0, -0.95}, {0, 0, -0.8}, {0, 0.1, -1}, {0, 0.3, -1}};
  double before[std::size(places)];
  for (std::size_t i = 0; i < std::size(places); ++i) before[i] = color_at(occluded, scene.pixel_of(places[i])).sum();
  scene.camera.middle.x() = -0.5;
  const Image aside = scene.draw();
  for (std::size_t i = 0; i < std::size(places); ++i) {
    CAPTURE(i, before[i]);
    CHECK(color_at(aside, scene.pixel_of(places[i])).sum() == Approx(before[i]).epsilon(0.02));
  }
}

}  // namespace fascia
