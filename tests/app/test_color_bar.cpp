// The color bar can be read whatever is behind it, and is left out where it would hide the picture.
#include <catch2/catch.hpp>

#include "app/overlay.h"
#include "tests/app/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kWidth = 640, kHeight = 720;  // at 720 rows a point is a pixel
constexpr std::uint8_t kTissue[4] = {190, 60, 50, 255};

/// The bar for velocity over a picture full of tissue.
Image bar_over_tissue(Backdrop backdrop, int width, int height) {
  Graphics graphics = open_graphics(headless(), false);
  Overlay overlay(graphics);
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.display.color = ColorBy::velocity;
  Session session(graphics, scene, false);
  session.look.backdrop = backdrop;
  Framebuffer framebuffer(width, height, 1);
  std::vector<std::uint8_t> tissue;
  for (int i = 0; i < width * height; ++i) tissue.insert(tissue.end(), kTissue, kTissue + 4);
  framebuffer.replace(tissue.data());
  overlay.draw_headless(session, framebuffer, false, std::nullopt, {});
  return framebuffer.read();
}

const std::uint8_t* pixel(const Image& image, int x, int y) { return &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)]; }

std::size_t covered(const Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += !std::equal(kTissue, kTissue + 3, pixel(image, x, y));
  return count;
}

}  // namespace

TEST_CASE("the color bar's numbers stand on a panel, dark on light or light on dark", "[color_bar]") {
  const auto backdrop = GENERATE(Backdrop::gradient, Backdrop::white, Backdrop::black, Backdrop::transparent);
  const Image image = bar_over_tissue(backdrop, kWidth, kHeight);
  const std::uint8_t* padding = pixel(image, kWidth - 17, kHeight / 2);  // right of the numbers
  const bool light = backdrop == Backdrop::white || backdrop == Backdrop::transparent;
  for (int c = 0; c < 3; ++c) CHECK((light ? padding[c] > 200 : padding[c] < 75));
}

TEST_CASE("the color bar's title stands clear of the number below it", "[color_bar]") {
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

TEST_CASE("a picture that is too small for a color bar has none", "[color_bar]") {
  CHECK(covered(bar_over_tissue(Backdrop::gradient, 160, 120)) == 0);
  const std::size_t usual = covered(bar_over_tissue(Backdrop::gradient, 320, 240));
  CHECK(usual > 0);
  CHECK(usual < 320 * 240 / 5);
}
