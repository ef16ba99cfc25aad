// The color bar is readable on any background, and is left out where it would hide the picture.
// Covers: grab_marks, overlay
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/overlay/color_bar.h"
#include "app/overlay/overlay.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kWidth = 640, kHeight = 720;  // at 720 rows a point is a pixel
constexpr std::uint8_t kTissue[4] = {190, 60, 50, 255};

/// A cube in the colors of its velocity.
struct Colored {
  Graphics graphics = open_graphics(headless(), false);
  Overlay overlay{graphics};
  Scene scene = [] {
    Scene opened = open_scene(source_dir() / "assets/scenes/cube.json");
    opened.display.color = ColorBy::velocity;
    return opened;
  }();
  Session session{graphics, scene, false};
};

/// Legend and grabs over a picture full of tissue.
Image over_tissue(Session& session, Overlay& overlay, const std::vector<GrabMark>& grabs = {}, int width = kWidth,
                  int height = kHeight) {
  Framebuffer framebuffer(width, height, 1);
  std::vector<std::uint8_t> tissue;
  for (int i = 0; i < width * height; ++i) tissue.insert(tissue.end(), kTissue, kTissue + 4);
  framebuffer.replace(tissue.data());
  overlay.draw_headless(session, framebuffer, false, std::nullopt, grabs);
  return framebuffer.read();
}

/// The bar for velocity.
Image bar_over_tissue(Backdrop backdrop, int width, int height) {
  Colored cube;
  cube.session.look.backdrop = backdrop;
  return over_tissue(cube.session, cube.overlay, {}, width, height);
}

const std::uint8_t* pixel(const Image& image, int x, int y) {
  return &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
}

std::size_t covered(const Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += !std::equal(kTissue, kTissue + 3, pixel(image, x, y));
  return count;
}

}  // namespace

TEST_CASE("the color bar's numbers are on a plate, dark on light or light on dark", "[color_bar]") {
  const auto backdrop = GENERATE(Backdrop::gradient, Backdrop::white, Backdrop::black, Backdrop::transparent);
  const Image image = bar_over_tissue(backdrop, kWidth, kHeight);
  const std::uint8_t* padding = pixel(image, kWidth - 17, kHeight / 2);  // right of the numbers
  const bool light = backdrop == Backdrop::white;  // a transparent picture may be placed on any background
  for (int c = 0; c < 3; ++c) CHECK((light ? padding[c] > 200 : padding[c] < 75));
}

TEST_CASE("the color bar's title does not touch the number below it", "[color_bar]") {
  const Image image = bar_over_tissue(Backdrop::white, kWidth, kHeight);
  const auto ink = [&](int y) {
    for (int x = kWidth - 110; x < kWidth - 22; ++x)
      if (pixel(image, x, y)[0] < 100) return true;
    return false;
  };
  int y = 0;
  const auto skip = [&](bool inked) {
    const int from = y;
    while (y < kHeight && ink(y) == inked) ++y;
    return y - from;
  };
  skip(false);
  CHECK(skip(true) >= 8);   // the title
  CHECK(skip(false) >= 6);  // and nothing
  REQUIRE(y < kHeight);
}

TEST_CASE("on a transparent picture the bar is readable over white and over black, and has no light plate",
          "[color_bar]") {
  Graphics graphics = open_graphics(headless(), false);
  Overlay overlay(graphics);
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.display.color = ColorBy::velocity;
  scene.display.background = Background::transparent;
  Session session(graphics, scene, false);
  Framebuffer framebuffer(kWidth, kHeight, 1);
  framebuffer.replace(std::vector<std::uint8_t>(4 * kWidth * kHeight, 0).data());
  overlay.draw_headless(session, framebuffer, false, std::nullopt, {});
  const Image image = framebuffer.read();
  const auto box = legend_box({0, 0, kWidth, kHeight}, session);
  REQUIRE(box);
  for (const double paper : {255.0, 0.0}) {
    const auto laid = [&](int x, int y) {
      const std::uint8_t* p = pixel(image, x, y);
      return p[3] / 255.0 * p[0] + (1 - p[3] / 255.0) * paper;
    };
    const int left = static_cast<int>(box->left), right = static_cast<int>(box->right),
              top = static_cast<int>(box->top);
    const double plate = laid(right - 4, kHeight / 2);
    double text = plate;  // the title's strongest pixel
    for (int y = top + 10; y < top + 26; ++y)
      for (int x = left + 8; x < right - 8; ++x)
        if (std::abs(laid(x, y) - plate) > std::abs(text - plate)) text = laid(x, y);
    CAPTURE(paper, plate, text);
    CHECK(plate < 90);
    CHECK(std::abs(text - plate) > 120);
  }
}

TEST_CASE("a grab's force is shown beside the color bar and inside the picture", "[color_bar]") {
  Colored cube;
  Session& session = cube.session;
  Overlay& overlay = cube.overlay;
  const auto drawn = [&](const std::vector<GrabMark>& grabs) { return over_tissue(session, overlay, grabs); };
  const Image without = drawn({});
  const auto box = legend_box({0, 0, kWidth, kHeight}, session);
  REQUIRE(box);
  // The number of pixels of a label at a free place, up to fractions of pixels.
  const auto label_pixels = [&](const Eigen::Vector2d& at, bool* in_bar) {
    const Ray ray = session.camera.ray(at.x(), at.y(), kWidth, kHeight);
    const Eigen::Vector3d place = ray.origin + 0.3 * ray.direction;
    GrabMark mark{{place.cast<float>(), place.cast<float>()}, Eigen::Vector3d(0, 1.25, 0)};
    const Image with = drawn({mark});
    int count = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        if (std::equal(pixel(with, x, y), pixel(with, x, y) + 3, pixel(without, x, y))) continue;
        ++count;
        *in_bar |= x >= box->left && x < box->right && y >= box->top && y < box->bottom;
      }
    return count;
  };
  bool in_bar = false;
  const int usual = label_pixels({200, 300}, &in_bar);
  REQUIRE(usual > 500);
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(kWidth - 90, kHeight / 2),
                                    {box->left - 30, kHeight / 2},
                                    {kWidth - 5, kHeight / 2},
                                    {kWidth - 5, 5},
                                    {300, 3},
                                    {5, kHeight - 5},
                                    {kWidth - 5, kHeight - 5}}) {
    const int count = label_pixels(at, &in_bar);
    CAPTURE(at.transpose(), usual, count);
    CHECK_FALSE(in_bar);
    CHECK(count > 0.9 * usual);
  }
}

TEST_CASE("a picture that is too small for a color bar has none", "[color_bar]") {
  CHECK(covered(bar_over_tissue(Backdrop::gradient, 160, 120)) == 0);
  const std::size_t usual = covered(bar_over_tissue(Backdrop::gradient, 320, 240));
  CHECK(usual > 0);
  CHECK(usual < 320 * 240 / 5);
}

namespace {

/// First and last column that is not tissue.
std::array<int, 2> columns_of(const Image& image) {
  std::array<int, 2> ends{image.width, -1};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (!std::equal(kTissue, kTissue + 3, pixel(image, x, y))) ends = {std::min(ends[0], x), std::max(ends[1], x)};
  return ends;
}

}  // namespace

TEST_CASE("the legend is at either edge or off, with its plate or without", "[color_bar]") {
  Colored cube;
  Session& session = cube.session;
  Overlay& overlay = cube.overlay;
  DisplaySettings display = cube.scene.display;
  const auto drawn = [&] {
    session.set_display(display);
    return over_tissue(session, overlay);
  };
  const std::array<int, 2> right = columns_of(drawn());
  display.legend.side = LegendSide::left;
  const std::array<int, 2> left = columns_of(drawn());
  CAPTURE(right[0], right[1], left[0], left[1]);
  CHECK(right[0] > kWidth / 2);
  CHECK(left[0] == kWidth - 1 - right[1]);
  CHECK(left[1] - left[0] == right[1] - right[0]);
  const Margins margins = legend_margins(session, kWidth, kHeight, 1, 0);
  CHECK(margins.right == 0);
  CHECK(margins.legend_left > left[1]);

  const std::size_t with_plate = covered(drawn());
  display.legend.plate = false;
  const std::size_t without = covered(drawn());
  CHECK(without > 1000);
  CHECK(without < 0.4 * static_cast<double>(with_plate));
  display.legend.side = LegendSide::off;
  CHECK(covered(drawn()) == 0);
  CHECK(!legend_box({0, 0, kWidth, kHeight}, session));
}

TEST_CASE("the legend grows with its font", "[color_bar]") {
  Colored cube;
  Session& session = cube.session;
  Overlay& overlay = cube.overlay;
  const auto size_with = [&](double font) {
    DisplaySettings display = cube.scene.display;
    display.legend.font_size = font;
    session.set_display(display);
    over_tissue(session, overlay);
    const auto box = legend_box({0, 0, kWidth, kHeight}, session);
    REQUIRE(box);
    return Eigen::Vector2f(box->right - box->left, box->bottom - box->top);
  };
  const Eigen::Vector2f usual = size_with(14.5), large = size_with(22), small = size_with(8);
  CAPTURE(usual.transpose(), large.transpose(), small.transpose());
  CHECK(large.x() / usual.x() == Approx(22 / 14.5).epsilon(0.06));  // texts have whole pixels
  CHECK(large.y() / usual.y() == Approx(22 / 14.5).epsilon(0.06));
  CHECK(small.x() / usual.x() == Approx(8 / 14.5).epsilon(0.06));
}

TEST_CASE("an arrow at an end of the bar shows that values lie beyond it", "[color_bar]") {
  Colored cube;
  Session& session = cube.session;
  Overlay& overlay = cube.overlay;
  for (int i = 0; i < 4; ++i) session.simulation.step();
  // Pixels between the title and the bar, and below the bar, in the colors of its ends.
  const auto arrows_with = [&](double low, double high) {
    DisplaySettings display = cube.scene.display;
    display.range = Eigen::Vector2d(low, high);
    session.set_display(display);
    session.settle_range();
    const Image image = over_tissue(session, overlay);
    const auto box = legend_box({0, 0, kWidth, kHeight}, session);
    REQUIRE(box);
    const auto count = [&](int begin, int end, float share) {
      const Eigen::Vector3f color = color_maps::dusk(share);
      int found = 0;
      for (int y = begin; y < end; ++y)
        for (int x = static_cast<int>(box->left); x < static_cast<int>(box->right); ++x) {
          float off = 0;
          for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(pixel(image, x, y)[c] / 255.0f - color[c]));
          found += off < 0.02f;
        }
      return found;
    };
    const int bar_top = static_cast<int>(box->top) + 10 + 30, bar_bottom = bar_top + 220;
    return std::array{count(bar_bottom + 1, bar_bottom + 9, 0), count(bar_top - 9, bar_top - 1, 1)};
  };
  const auto none = arrows_with(-1, 10), above = arrows_with(-1, 1e-4), both = arrows_with(1e-5, 1e-4);
  CAPTURE(none, above, both);
  CHECK(none == std::array{0, 0});
  CHECK(above[0] == 0);
  CHECK(above[1] > 30);
  CHECK(both[0] > 30);
  CHECK(both[1] == above[1]);
}
