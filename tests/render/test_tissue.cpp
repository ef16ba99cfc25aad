// The look of tissue: light from all sides, paints, detail fixed to the tissue, and what the quality of a picture
// changes.
// Covers: render/passes/shadow_map
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::color_at;
using test::Scene;

constexpr double kRadius = 0.5;

Scene ball() {
  Scene scene(test::sphere({0, 0, 0}, kRadius, 40));
  scene.look.ground = scene.look.shadow = false;
  return scene;
}

Vector3d linear(const Vector3d& srgb) {
  return srgb.unaryExpr([](double c) { return double(linear_of_srgb(static_cast<float>(c))); });
}

double brightness(const Vector3d& color) { return color.dot(Vector3d(0.30, 0.59, 0.11)); }

// Matte and of one color, so that a picture's linear colors are the light times the color.
TissuePaint matte() {
  TissuePaint paint;
  paint.color = paint.patches = paint.lines = {0.5f, 0.4f, 0.3f};
  paint.wetness = paint.scattering = 0;
  return paint;
}

TissuePaint patchy() {
  TissuePaint paint = matte();
  paint.patches = {0.2f, 0.1f, 0.1f};
  paint.patchiness = 1;
  return paint;
}

bool on_body(const Image& with, const Image& without, std::size_t pixel) {
  return !std::equal(with.rgba.begin() + std::ptrdiff_t(4 * pixel), with.rgba.begin() + std::ptrdiff_t(4 * pixel + 4),
                     without.rgba.begin() + std::ptrdiff_t(4 * pixel));
}

long different(const Image& a, const Image& b) {
  long count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    count += !std::equal(a.rgba.begin() + std::ptrdiff_t(i), a.rgba.begin() + std::ptrdiff_t(i + 4),
                         b.rgba.begin() + std::ptrdiff_t(i));
  return count;
}

// The linear factor of the color at vertices that face the camera, from the same body with and without patches.
std::vector<Vector3d> factors(Scene scene) {
  scene.look.quality.detail = true;
  scene.paints = {patchy()};
  const Image patched = scene.draw();
  scene.paints = {matte()};
  const Image plain = scene.draw();
  std::vector<Vector3d> found;
  const std::vector<Vector3d>& rest = scene.rest.empty() ? scene.shape.positions : scene.rest;
  for (std::size_t v = 0; v < rest.size(); v += 7) {
    if (rest[v].normalized().dot(Vector3d(0, 0.25, 1).normalized()) < 0.8) continue;  // a cap that stays in view
    const Vector2d at = scene.pixel_of(scene.shape.positions[v]);
    found.push_back(linear(color_at(patched, at)).cwiseQuotient(linear(color_at(plain, at))));
  }
  return found;
}

}  // namespace

TEST_CASE("tissue: the underside is shaded, not one flat color") {
  const auto context = test::each_context();
  Scene scene = ball();
  scene.camera.target = {0, 0, 0};
  scene.camera.eye = {0.3, -2.4, 0.6};
  const Image image = scene.draw();
  double least = 1, most = 0;
  for (const Vector3d& p : scene.shape.positions) {
    const Vector3d n = p / kRadius;
    const Vector3d view = (scene.camera.eye - p).normalized();
    if (n.y() > -0.4 || n.dot(view) < 0.35 || n.dot(test::toward_light(scene.look)) > -0.1) continue;
    const double shown = brightness(linear(color_at(image, scene.pixel_of(p))));
    least = std::min(least, shown);
    most = std::max(most, shown);
  }
  CAPTURE(least, most);
  CHECK(most > 1.3 * least);
  CHECK(least > 0.05);  // and nowhere black
}

TEST_CASE("tissue: patches are fixed to the tissue under translation, rotation and deformation") {
  const auto context = test::each_context();
  const Scene at_rest = ball();
  const std::vector<Vector3d> before = factors(at_rest);
  REQUIRE(before.size() > 20);
  double spread = 0;
  for (const Vector3d& f : before) spread = std::max(spread, std::abs(f.x() - before[0].x()));
  CHECK(spread > 0.2);  // there are patches
  const auto moved = [&](const Eigen::Affine3d& motion) {
    Scene scene = at_rest;
    scene.rest = scene.shape.positions;
    for (Vector3d& p : scene.shape.positions) p = motion * p;
    return factors(scene);
  };
  const Eigen::Affine3d shift(Eigen::Translation3d(0.11, -0.07, 0.05)),
      turn(Eigen::AngleAxisd(0.35, Vector3d(0.2, 0.3, 1).normalized())), stretch(Eigen::Scaling(1.3, 0.8, 1.0));
  for (const Eigen::Affine3d& motion : {shift, turn, stretch}) {
    const std::vector<Vector3d> after = moved(motion);
    REQUIRE(after.size() == before.size());
    double off = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      off += (after[i] - before[i]).cwiseAbs().mean() / double(before.size());
    CAPTURE(off, spread);
    // A pixel's center is up to half a pixel from its vertex, and colors have 8 bits.
    CHECK(off < 0.1 * spread);
  }
}

TEST_CASE("tissue: every region has its paint, on the surface, on a cut and on separate tets") {
  const auto context = test::each_context();
  Scene scene(test::box({-1, 0, -1}, {1, 2, 1}, 1));
  scene.look.ground = scene.look.shadow = false;
  scene.triangle_region.assign(scene.shape.triangles.size(), 0);
  for (std::size_t i = 0; i < scene.shape.triangles.size(); ++i) {
    Vector3d middle = Vector3d::Zero();
    for (const std::uint32_t v : scene.shape.triangles[i]) middle += scene.shape.positions[v] / 3;
    scene.triangle_region[i] = middle.y() > 1.9 ? 1 : 0;
  }
  const auto hue = [](const Vector3d& color) { return Vector3d(linear(color) / linear(color).sum()); };
  TissuePaint green = matte(), blue = matte();
  green.color = {0.1f, 0.6f, 0.1f};
  blue.color = {0.1f, 0.1f, 0.6f};
  scene.paints = {green, blue};
  const bool wireframe = GENERATE(false, true);
  scene.look.wireframe = wireframe;
  scene.look.quality = GENERATE(kDraftQuality, kFullQuality);
  const Image image = scene.draw();
  const Vector3d side = hue(color_at(image, scene.pixel_of({0.3, 0.8, 1}))),
                 top = hue(color_at(image, scene.pixel_of({0.3, 2, 0.2})));
  CAPTURE(side.transpose(), top.transpose(), wireframe);
  CHECK(side.y() > 0.8);
  CHECK(top.z() > 0.8);

  scene.paints = {blue};  // one paint for all
  CHECK(hue(color_at(scene.draw(), scene.pixel_of({0.3, 0.8, 1}))).z() > 0.8);
}

TEST_CASE("tissue: corner colors replace the paint's color, unless the paint is over them") {
  const auto context = test::each_context();
  Scene scene = ball();
  scene.colors.assign(3 * scene.shape.triangles.size(), 0xff20a020u);  // green
  scene.paints = {matte()};
  const Vector2d middle = scene.pixel_of({0, 0, kRadius});
  const Vector3d corner = color_at(scene.draw(), middle);
  scene.paints[0].over_corners = true;
  const Vector3d paint = color_at(scene.draw(), middle);
  CAPTURE(corner.transpose(), paint.transpose());
  CHECK(corner.y() > 1.5 * corner.x());
  CHECK(paint.x() > paint.y());
}

TEST_CASE("tissue: neither detail nor paints change a heat map or the colors of regions") {
  const auto context = test::each_context();
  Scene scene = ball();
  for (const Vector3d& p : scene.shape.positions) scene.shape.scalars.push_back(static_cast<float>(p.x() + 0.5));
  scene.look.heat_map = GENERATE(true, false);
  scene.look.regions = !scene.look.heat_map;
  scene.look.shadow = true;
  for (std::size_t i = 0; i < scene.shape.triangles.size(); ++i) scene.triangle_region.push_back(i % 3);
  const Image plain = scene.draw();
  scene.look.quality.detail = true;
  TissuePaint paint = patchy();
  paint.bumpiness = 0.5f;
  paint.wetness = TissuePaint{}.wetness;
  paint.scattering = TissuePaint{}.scattering;
  if (scene.look.heat_map) scene.paints = {paint, matte(), paint};
  CAPTURE(scene.look.heat_map);
  CHECK(different(plain, scene.draw()) == 0);
}

TEST_CASE("tissue: detail and soft shadows change the body only") {
  const auto context = test::each_context();
  Scene scene(test::sphere({0, 0.7, 0}, kRadius, 30));
  scene.look.ground_height = 0;
  scene.paints = {patchy()};
  const Image draft = scene.draw();
  scene.look.quality = kFullQuality;
  scene.look.quality.edge_smoothing = false;
  const Image full = scene.draw();
  Scene empty = scene;
  empty.look.quality = kDraftQuality;
  empty.paints[0].color = {0.1f, 0.9f, 0.2f};  // marks the body's pixels
  const Image mask = empty.draw();
  long on = 0, off = 0;
  for (std::size_t pixel = 0; pixel < draft.rgba.size() / 4; ++pixel) {
    const bool differs = on_body(draft, full, pixel);
    (on_body(draft, mask, pixel) ? on : off) += differs;
  }
  CAPTURE(on, off);
  CHECK(on > 1000);
  CHECK(off == 0);
}

TEST_CASE("tissue: smoothing lowers the contrast of edges with one sample, and is absent with several") {
  const auto context = test::each_context();
  Scene scene = ball();
  const auto jumps = [&] {  // places where the color jumps from body to background at once
    const Image image = scene.draw();
    long count = 0;
    for (int y = 0; y < scene.height; ++y)
      for (int x = 1; x < scene.width; ++x)
        count += (color_at(image, x, y) - color_at(image, x - 1, y)).cwiseAbs().maxCoeff() > 0.4;
    return count;
  };
  const long hard = jumps();
  scene.look.quality.edge_smoothing = true;
  const long soft = jumps();
  CAPTURE(hard, soft);
  CHECK(soft < 0.8 * double(hard));
  scene.samples = 4;
  const Image smoothed = scene.draw();
  scene.look.quality.edge_smoothing = false;
  CHECK(different(smoothed, scene.draw()) == 0);
}

TEST_CASE("tissue: the edge of a contact shadow widens with the caster's distance") {
  const auto context = test::each_context();
  // A floor of tissue and a plate above it, seen from above along the shadow's straight edge.
  const auto edge_width = [](double height, const Quality& quality) {
    test::Shape shape = test::box({-2, -0.2, -2}, {2, 0, 2}, 1);
    const test::Shape plate = test::box({-0.6, height, -0.6}, {0.6, height + 0.05, 0.6}, 1);
    const auto offset = static_cast<std::uint32_t>(shape.positions.size());
    shape.positions.insert(shape.positions.end(), plate.positions.begin(), plate.positions.end());
    for (const auto& [a, b, c] : plate.triangles) shape.triangles.push_back({a + offset, b + offset, c + offset});
    Scene scene(shape);
    scene.look.ground = false;
    scene.look.center = {0, 0, 0};
    scene.look.radius = 2.0;
    scene.look.quality = quality;
    scene.paints = {matte()};
    scene.width = 640;
    scene.height = 480;
    scene.camera.target = {0, 0, 0};
    scene.camera.eye = {0.01, 5.5, 0.01};
    scene.camera.up = {0, 0, -1};
    const Image image = scene.draw();
    const Vector3d light = test::toward_light(scene.look);
    // The edge at z of the plate's middle, on the side away from the light.
    const Vector3d foot = Vector3d(light.x() > 0 ? -0.6 : 0.6, height, 0) - light * (height / light.y());
    std::vector<double> shown;
    for (double t = -0.5; t <= 0.5; t += 0.005)
      shown.push_back(brightness(linear(color_at(image, scene.pixel_of({foot.x() + t, 0, foot.z()})))));
    const double low = *std::min_element(shown.begin(), shown.end()),
                 high = *std::max_element(shown.begin(), shown.end());
    REQUIRE(high > 1.5 * low);
    long between = 0;
    for (const double s : shown) between += s > low + 0.15 * (high - low) && s < low + 0.85 * (high - low);
    return 0.005 * double(between);
  };
  const double near = edge_width(0.25, kFullQuality), far = edge_width(0.9, kFullQuality),
               far_draft = edge_width(0.9, kDraftQuality);
  CAPTURE(near, far, far_draft);
  CHECK(far > 2 * near);
  CHECK(far > 2 * far_draft);
}

}  // namespace fascia
