// Heat map, wireframe and marks.
// Covers: render/passes/look_defines, render/passes/marks, render/view/color_map
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::color_at;
using test::Scene;

/// A rectangle that faces the key light, seen from the direction of the light.
Scene plate_toward_light() {
  Look look;
  const Vector3d light = test::toward_light(look), right = Vector3d(0, 1, 0).cross(light).normalized(),
                 up = light.cross(right);
  test::Shape shape;
  shape.positions = {-right - up, right - up, right + up, -right + up};
  shape.triangles = {{0, 1, 2}, {0, 2, 3}};
  shape.scalars = {0, 0, 0, 0};
  Scene scene(shape);
  scene.camera.target = {0, 0, 0};
  scene.camera.eye = 4 * light;
  scene.look.ground_height = -3;
  scene.look.heat_map = true;
  return scene;
}

Vector3d oklab(const Eigen::Vector3f& srgb) {
  const Vector3d c = srgb.cast<double>().unaryExpr(
      [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); });
  Eigen::Matrix3d cones, opponents;
  cones << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566, 0.0883024619,
      0.2817188376, 0.6299787005;
  opponents << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099, 0.0259040371,
      0.7827717662, -0.8086757660;
  return opponents * (cones * c).unaryExpr([](double x) { return std::cbrt(x); });
}

}  // namespace

TEST_CASE("color maps: inside the display's colors, in perceptually even steps") {
  // The fits have steps that differ by up to a fifth; those of a rainbow differ by a factor of five and more. The steps
  // of the diverging map, which passes through two hues and reverses in its middle, differ by at most a factor of 2.2,
  // except in that middle.
  const auto [name, map, diverging] =
      GENERATE(table<std::string, const ColorMapCurve*, bool>({{"dusk", &color_maps::dusk, false},
                                                               {"ember", &color_maps::ember, false},
                                                               {"polar", &color_maps::polar, true},
                                                               {"grey", &color_maps::grey, false}}));
  const int count = 100;
  double least = 1e9, most = 0;
  for (int i = 0; i < count; ++i) {
    const float t = float(i) / count, next = float(i + 1) / count;
    const Eigen::Vector3f a = (*map)(t), b = (*map)(next);
    CAPTURE(name, i, a.transpose());
    REQUIRE(a.minCoeff() >= 0);
    REQUIRE(a.maxCoeff() <= 1);
    const Vector3d step = count * (oklab(b) - oklab(a));
    if (diverging) {
      CHECK(std::abs(oklab(a).x() - oklab((*map)(1 - t)).x()) < 0.003);
      if (std::abs(i + 0.5 - count / 2) > 3) CHECK((i < count / 2 ? 1 : -1) * step.x() > 0);
      if (std::abs(i - count / 2) < 10) continue;
    } else {
      CHECK(step.x() > 0.35);
    }
    least = std::min(least, step.norm());
    most = std::max(most, step.norm());
  }
  CAPTURE(name, least, most);
  CHECK(most < (diverging ? 2.2 : 1.25) * least);
  CHECK((*map)(-1) == (*map)(0));
  CHECK((*map)(2) == (*map)(1));
  const Vector3d middle = oklab((*map)(0.5f));
  if (diverging) CHECK((middle.tail<2>().norm() < 0.03 && middle.x() > 0.9));
}

TEST_CASE("render: a fully lit surface shows the color bar's colors") {
  const auto context = test::each_context();
  Scene scene = plate_toward_light();
  scene.look.range = {-2, 6};
  for (const bool shadow : {false, true}) {
    scene.look.shadow = shadow;
    for (const float t : {-0.2f, 0.0f, 0.13f, 0.5f, 0.77f, 1.0f, 1.3f}) {
      scene.shape.scalars.assign(4, -2 + 8 * t);
      const Vector3d color = color_at(scene.draw(), scene.width / 2.0, scene.height / 2.0);
      const Eigen::Vector3f expected = heat_color(t);
      CAPTURE(shadow, t, color.transpose() * 255, expected.transpose() * 255);
      // Half a step of rounding, and 0.4 of a step by which full light overshoots white.
      CHECK((color - expected.cast<double>()).cwiseAbs().maxCoeff() <= 1.0 / 255);
    }
  }
}

TEST_CASE("render: a diverging map has its middle at the neutral value, for any range") {
  const auto context = test::each_context();
  Scene scene = plate_toward_light();
  scene.look.range = {-2, 6};
  scene.look.neutral = 0;
  scene.look.color_map = &color_maps::polar;
  const auto shown = [&](float scalar) {
    scene.shape.scalars.assign(4, scalar);
    return color_at(scene.draw(), scene.width / 2.0, scene.height / 2.0);
  };
  for (const float scalar : {-2.0f, -1.0f, 0.0f, 3.0f, 6.0f}) {
    const Vector3d color = shown(scalar), expected = color_maps::polar(0.5f + scalar / 12).cast<double>();
    CAPTURE(scalar, color.transpose() * 255, expected.transpose() * 255);
    CHECK((color - expected).cwiseAbs().maxCoeff() <= 1.0 / 255);
  }
  CHECK(shown(-5) == shown(-2));  // beyond the range's end, which the color bar shows
}

TEST_CASE("render: the heat map is linear between vertices, in perspective too") {
  const auto context = test::each_context();
  Scene scene = plate_toward_light();
  scene.shape.scalars = {0, 1, 1, 0};
  scene.camera.orbit(0.5, 0.1);
  const Image image = scene.draw();
  const Vector3d left = (scene.shape.positions[0] + scene.shape.positions[3]) / 2;
  const Vector3d right = (scene.shape.positions[1] + scene.shape.positions[2]) / 2;
  for (double t = 0.05; t < 1; t += 0.1) {
    const Vector2d place = scene.pixel_of(left + t * (right - left));
    const Vector3d color = color_at(image, place), expected = heat_color(float(t)).cast<double>();
    CAPTURE(t, color.transpose() * 255, expected.transpose() * 255);
    // The pixel's center is up to half a pixel off, 1/400 of the scale, where colors change by up to 3 per unit.
    CHECK((color - expected).cwiseAbs().maxCoeff() < 3.5 / 255);
  }
}

TEST_CASE("render: an empty range of the heat map shows its lowest color, not garbage") {
  const auto context = test::each_context();
  Scene scene = plate_toward_light();
  scene.look.range = {2, 2};
  scene.shape.scalars.assign(4, 2);
  const Vector3d color = color_at(scene.draw(), scene.width / 2.0, scene.height / 2.0);
  CHECK((color - heat_color(0).cast<double>()).cwiseAbs().maxCoeff() <= 1.0 / 255);
}

TEST_CASE("render: the wireframe darkens edges and leaves the triangles' middles") {
  const auto context = test::each_context();
  const bool heat_map = GENERATE(false, true);
  Scene scene(test::box({-1, 0, -1}, {1, 2, 1}, 2));
  scene.look.heat_map = heat_map;
  const Image plain = scene.draw();
  scene.look.wireframe = true;
  const Image wire = scene.draw();
  int edges = 0;
  for (const auto& triangle : scene.shape.triangles) {
    const Vector3d a = scene.shape.positions[triangle[0]], b = scene.shape.positions[triangle[1]],
                   c = scene.shape.positions[triangle[2]];
    if ((b - a).cross(c - a).dot(scene.camera.eye - a) <= 0) continue;  // seen from behind
    const Vector2d middle = scene.pixel_of((a + b + c) / 3), edge = scene.pixel_of(0.3 * a + 0.7 * b);
    CAPTURE(middle.transpose(), edge.transpose());
    CHECK((color_at(wire, middle) - color_at(plain, middle)).cwiseAbs().maxCoeff() <= 1.0 / 255);
    edges += color_at(wire, edge).sum() < 0.85 * color_at(plain, edge).sum();
  }
  CHECK(edges >= 20);  // of 24 visible triangles: an edge at the silhouette may fall just outside
}

TEST_CASE("render: marks are at their vertices, and hidden behind the body") {
  const auto context = test::each_context();
  Scene scene(test::sphere({0, 0.7, 0}, 0.5, 20));
  const Image plain = scene.draw();
  const Vector3d center(0, 0.7, 0);
  std::uint32_t front = 0, back = 0;
  for (std::uint32_t i = 0; i < scene.shape.positions.size(); ++i) {
    const auto toward = [&](std::uint32_t v) {
      return (scene.shape.positions[v] - center).dot(scene.camera.eye - center);
    };
    if (toward(i) > toward(front)) front = i;
    if (toward(i) < toward(back)) back = i;
  }
  const Vector2d at_front = scene.pixel_of(scene.shape.positions[front]);
  scene.marked = {front};
  const Vector3d fixed = color_at(scene.draw(), at_front), bare = color_at(plain, at_front);
  CAPTURE(fixed.transpose(), bare.transpose());
  CHECK((fixed - bare).norm() > 0.2);
  scene.marked.clear();
  scene.grabbed = {front};
  const Image image = scene.draw();
  const Vector3d grabbed = color_at(image, at_front);
  CAPTURE(grabbed.transpose());
  CHECK(grabbed.sum() > fixed.sum() + 0.5);
  CHECK(color_at(image, at_front + Vector2d(12, 0)) == color_at(plain, at_front + Vector2d(12, 0)));
  scene.grabbed.clear();
  scene.marked = {back};
  CHECK(scene.draw().rgba == plain.rgba);
}

TEST_CASE("render: the grab spring is drawn over the surface") {
  const auto context = test::each_context();
  Scene scene(test::sphere({0, 0.7, 0}, 0.5, 20));
  const Image plain = scene.draw();
  scene.grab = GrabArrow{{0, 0.7f, 0}, {0.1f, 1.0f, 0.05f}};  // all of it inside the body
  const Image image = scene.draw();
  const Vector3d middle = (scene.grab->from + scene.grab->to).cast<double>() / 2;
  const Vector3d color = color_at(image, scene.pixel_of(middle));
  CAPTURE(color.transpose());
  CHECK((color - color_at(plain, scene.pixel_of(middle))).norm() > 0.2);
  CHECK(difference(image, plain).share < 0.03);
  // A spring without length is a dot, not garbage.
  scene.grab->to = scene.grab->from;
  CHECK(difference(scene.draw(), plain).share < 0.01);
}

}  // namespace fascia
