// The picture of a body on its ground: silhouette, shadows, scales, contexts.
// Covers: render/passes/shadow_map, render/passes/surface_renderer
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::color_at;
using test::Scene;

Scene sphere_over_ground() {
  Scene scene(test::sphere({0, 0.7, 0}, 0.5, 40));
  scene.camera.zoom(1.6);
  return scene;
}

/// A copy of the scene at another scale, with the same picture.
Scene scaled(Scene scene, double factor) {
  for (Vector3d& p : scene.shape.positions) p *= factor;
  scene.look.center *= factor;
  scene.look.radius *= factor;
  scene.look.ground_height *= factor;
  scene.camera.eye *= factor;
  scene.camera.target *= factor;
  return scene;
}

}  // namespace

TEST_CASE("render: a sphere's silhouette is where the camera projects it") {
  const auto context = test::each_context();
  Scene scene(test::sphere({0.1, 0.7, -0.2}, 0.5, 60));
  scene.look.ground = scene.look.shadow = false;
  scene.camera.orbit(0.4, 0.2);
  const Image with = scene.draw();
  scene.shape.triangles.clear();
  const Image without = scene.draw();
  const double pixel = scene.camera.pixel_size({0.1, 0.7, -0.2}, scene.width, scene.height);
  int wrong = 0, body = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const Ray ray = scene.camera.ray(x + 0.5, y + 0.5, scene.width, scene.height);
      const Vector3d to_center = Vector3d(0.1, 0.7, -0.2) - ray.origin;
      const double distance = to_center.cross(ray.direction).norm();
      if (std::abs(distance - 0.5) < 1.5 * pixel) continue;  // the edge itself, and the polyhedron's 0.2 pixel
      const bool drawn = color_at(with, x, y) != color_at(without, x, y);
      body += drawn;
      wrong += drawn != (distance < 0.5);
    }
  }
  CAPTURE(body);
  CHECK(wrong == 0);
  CHECK(body > 5000);
}

TEST_CASE("render: the shadow darkens only the ground under the body") {
  const auto context = test::each_context();
  Scene scene = sphere_over_ground();
  const Image shadow = scene.draw();
  scene.look.shadow = false;
  const Image plain = scene.draw();
  const Vector3d light = test::toward_light(scene.look), center(0, 0.7, 0);
  const Vector3d middle = center - light * (center.y() / light.y());
  const Vector2d dark = scene.pixel_of(middle);
  CAPTURE(dark.transpose());
  CHECK(color_at(shadow, dark).sum() < 0.75 * color_at(plain, dark).sum());
  // Beside the shadow the ground is as bright as without.
  for (const Vector3d& away : {Vector3d(-1, 0, 0.3), Vector3d(-0.5, 0, 0.4), Vector3d(0, 0, 0.7)}) {
    const Vector2d place = scene.pixel_of(away);
    CAPTURE(place.transpose());
    CHECK((color_at(shadow, place) - color_at(plain, place)).cwiseAbs().maxCoeff() <= 1.0 / 255);
  }
  // Penumbra: from the middle outwards the light increases gradually.
  int steps = 0;
  Vector3d last = color_at(shadow, dark);
  for (double r = 0; r < 1; r += 0.02) {
    const Vector3d color = color_at(shadow, scene.pixel_of(middle + Vector3d(r, 0, 0)));
    steps += color.sum() > last.sum() + 2.0 / 255;
    last = color;
  }
  CHECK(steps >= 5);
}

// Parts of the ground are then beyond the shadow map's depth, which is 1 where nothing is in the light's way.
TEST_CASE("render: a body far above the ground shadows only what lies in its light") {
  const auto context = test::each_context();
  const Vector3d center(0, 2.2, 0);
  Scene scene(test::sphere(center, 0.5, 16));
  scene.look.ground_height = 0;
  scene.camera.frame({-2, 0, -2}, {4, 2.7, 2});
  scene.camera.fit({-2, 0, -2}, {4, 2.7, 2}, double(scene.width) / scene.height);
  const Image shadow = scene.draw();
  scene.look.shadow = false;
  const Image plain = scene.draw();
  const Vector3d light = test::toward_light(scene.look), up(0, 1, 0), across = up.cross(light).normalized(),
                 along = light.cross(across);
  const auto below = [&](double right, double ahead) {
    const Vector3d start = center + right * across + ahead * along;
    return scene.pixel_of(start - light * (start.y() / light.y()));
  };
  CHECK(color_at(shadow, below(0, 0)).sum() < 0.9 * color_at(plain, below(0, 0)).sum());
  for (const auto& [right, ahead] :
       {std::pair(0.0, 1.15), std::pair(-0.5, 1.2), std::pair(1.15, 0.0), std::pair(0.0, -1.15)}) {
    CAPTURE(right, ahead, below(right, ahead).transpose());
    const Vector3d difference = color_at(shadow, below(right, ahead)) - color_at(plain, below(right, ahead));
    CHECK(difference.cwiseAbs().maxCoeff() <= 1.0 / 255);
  }
}

TEST_CASE("render: no acne: a lit sphere with shadows looks as without if nothing blocks the light") {
  const auto context = test::each_context();
  for (const double factor : {1e-3, 1.0}) {
    Scene scene = scaled(sphere_over_ground(), factor);
    const Image shadow = scene.draw();
    scene.look.shadow = false;
    const Image plain = scene.draw();
    const Vector3d light = test::toward_light(scene.look);
    int compared = 0;
    for (std::size_t i = 0; i < scene.shape.positions.size(); ++i) {
      const Vector3d p = scene.shape.positions[i], n = (p - factor * Vector3d(0, 0.7, 0)).normalized();
      if (n.dot(light) < 0.15 || n.dot((scene.camera.eye - p).normalized()) < 0.3) continue;
      const Vector2d place = scene.pixel_of(p);
      CAPTURE(factor, i, place.transpose());
      REQUIRE((color_at(shadow, place) - color_at(plain, place)).cwiseAbs().maxCoeff() <= 2.0 / 255);
      ++compared;
    }
    CHECK(compared > 300);
  }
}

TEST_CASE("render: a body casts its shadow on itself") {
  const auto context = test::each_context();
  // A plate with a smaller one hovering above.
  Scene scene(test::box({-1, 0.1, -1}, {1, 0.2, 1}, 4));
  const test::Shape roof = test::box({-0.3, 0.6, -0.3}, {0.3, 0.65, 0.3}, 2);
  const auto first = static_cast<std::uint32_t>(scene.shape.positions.size());
  scene.shape.positions.insert(scene.shape.positions.end(), roof.positions.begin(), roof.positions.end());
  for (const auto& [a, b, c] : roof.triangles) scene.shape.triangles.push_back({a + first, b + first, c + first});
  scene.camera.orbit(0, 0.6);
  const Vector3d light = test::toward_light(scene.look);
  const Vector3d shaded = Vector3d(0, 0.6, 0) - light * (0.4 / light.y()), lit(-0.7, 0.2, 0.7);
  const Image image = scene.draw();
  CAPTURE(scene.pixel_of(shaded).transpose(), scene.pixel_of(lit).transpose());
  CHECK(color_at(image, scene.pixel_of(shaded)).sum() < 0.75 * color_at(image, scene.pixel_of(lit)).sum());
}

TEST_CASE("render: the same frame twice gives the same bits, with every feature") {
  const auto context = test::each_context();
  Scene scene = sphere_over_ground();
  scene.look.wireframe = scene.look.heat_map = true;
  scene.marked = {3, 40, 500};
  scene.grabbed = {700, 701};
  scene.grab = GrabArrow{{0, 1, 0.5f}, {0.4f, 1.2f, 0.6f}};
  scene.samples = 4;
  const Image first = scene.draw(), second = scene.draw();
  REQUIRE(first.rgba.size() == second.rgba.size());
  long different = 0;
  for (std::size_t i = 0; i < first.rgba.size(); ++i) different += first.rgba[i] != second.rgba[i];
  CHECK(different == 0);
}

TEST_CASE("render: OSMesa and EGL draw the same picture") {
  for (const int samples : {1, 4}) {
    Scene scene = sphere_over_ground();
    scene.marked = {3, 40, 500};
    scene.samples = samples;
    Image images[2];
    images[0] = [&] {
      const auto context = make_osmesa_context({});
      return scene.draw();
    }();
    images[1] = [&] {
      const auto context = make_egl_context({}, EglDevices::any);
      return scene.draw();
    }();
    const double mean = difference(images[0], images[1]).mean;
    CAPTURE(samples, mean);
    CHECK(mean < 0.5 / 255);
  }
}

TEST_CASE("render: storage blocks and buffer textures give the same picture") {
  const auto context = test::each_context();
  const Scene scene = sphere_over_ground();
  CHECK(scene.draw(gl::LoadPath::storage).rgba == scene.draw(gl::LoadPath::texel).rgba);
}

TEST_CASE("render: a millimeter and a hundred meters look the same") {
  const auto context = test::each_context();
  const Scene scene = sphere_over_ground();
  const Image image = scene.draw();
  for (const double factor : {1e-3, 100.0}) {
    // The grid is the same for powers of ten; what remains is the rounding of coordinates.
    const ImageDifference off = difference(image, scaled(scene, factor).draw());
    CAPTURE(factor, off.mean, off.share);
    CHECK(off.mean < 0.5 / 255);
    CHECK(off.share < 0.005);
  }
}

TEST_CASE("render: z up looks like y up") {
  const auto context = test::each_context();
  const Scene scene = sphere_over_ground();
  Scene turned = scene;
  const auto turn = [](Vector3d& p) { p = Vector3d(p.x(), -p.z(), p.y()); };
  for (Vector3d& p : turned.shape.positions) turn(p);
  turn(turned.look.center);
  turn(turned.look.up);
  turn(turned.camera.eye);
  turn(turned.camera.target);
  turn(turned.camera.up);
  const double mean = difference(scene.draw(), turned.draw()).mean;
  CAPTURE(mean);
  CHECK(mean < 0.5 / 255);
}

TEST_CASE("render: the ground has no horizon and is invisible from below") {
  const auto context = test::each_context();
  Scene scene = sphere_over_ground();
  scene.look.shadow = false;
  const Image with = scene.draw();
  scene.look.ground = false;
  const Image without = scene.draw();
  // Along the left border from top to bottom, away from the body: the ground fades in over many rows, grid included.
  const auto seen = [&](int row) { return std::abs((color_at(with, 2, row) - color_at(without, 2, row)).mean()); };
  int first = 0;
  while (first < scene.height - 1 && seen(first) < 1.0 / 255) ++first;
  double begin = 0, most = 0;
  for (int row = first; row < scene.height; ++row) {
    most = std::max(most, seen(row));
    if (row < first + 12) begin = std::max(begin, seen(row));
  }
  CAPTURE(first, begin, most);
  CHECK(most > 0.1);
  CHECK(begin < 0.03);

  scene.camera.eye.y() = -0.2;
  const Image from_below = scene.draw();
  scene.look.ground = true;
  CHECK(scene.draw().rgba == from_below.rgba);
}

TEST_CASE("render: inner faces are distinguishable from outer ones") {
  const auto context = test::each_context();
  Scene scene = sphere_over_ground();
  const Image outside = scene.draw();
  for (auto& triangle : scene.shape.triangles) std::swap(triangle[1], triangle[2]);
  const Image inside_out = scene.draw();
  const Vector2d middle = scene.pixel_of({0, 0.7, 0});
  CAPTURE(color_at(outside, middle).transpose(), color_at(inside_out, middle).transpose());
  CHECK((color_at(outside, middle) - color_at(inside_out, middle)).norm() > 0.1);
  CHECK(color_at(outside, middle).x() > color_at(outside, middle).z());
}

TEST_CASE("render: multisampling softens the silhouette") {
  const auto context = test::each_context();
  Scene scene = sphere_over_ground();
  scene.look.ground = scene.look.shadow = false;
  const auto steps = [&](int samples) {  // places where the color jumps from body to background at once
    scene.samples = samples;
    const Image image = scene.draw();
    int count = 0;
    for (int y = 0; y < scene.height; ++y)
      for (int x = 1; x < scene.width; ++x)
        count += (color_at(image, x, y) - color_at(image, x - 1, y)).cwiseAbs().maxCoeff() > 0.4;
    return count;
  };
  const int hard = steps(1), soft = steps(4);
  CAPTURE(hard, soft);
  CHECK(soft < hard / 2);
}

}  // namespace fascia
