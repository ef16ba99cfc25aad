// Smoothing of edges in pictures with one sample per pixel.
#include "render/passes/edge_smoothing.h"

#include "tests/render/scene_support.h"

namespace fascia {
namespace {

// Filters a picture whose colors are those of `color_of(x, y)`.
template <class ColorOf>
Image smoothed(int width, int height, const ColorOf& color_of) {
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  Framebuffer target(width, height, 1);
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint8_t grey = color_of(x, y);
      rgba.insert(rgba.end(), {grey, grey, grey, 255});
    }
  target.replace(rgba.data());
  EdgeSmoothing(programs, width, height).smooth(target);
  CHECK(gl::GetError() == GL_NO_ERROR);
  return target.read();
}

int grey_at(const Image& image, int x, int y) { return image.rgba[4 * static_cast<std::size_t>(y * image.width + x)]; }

}  // namespace

TEST_CASE("a slanted edge gets values between its sides, and the mean of the picture stays") {
  const auto context = test::each_context();
  // One step of the stair every six columns; exact coverage is the share of a pixel below the line.
  constexpr int kWidth = 60, kHeight = 30, kLow = 40, kHigh = 220;
  const auto line = [](double x) { return 10 + x / 6; };
  const auto stair = [&](int x, int y) { return std::uint8_t(y + 0.5 < line(x + 0.5) ? kHigh : kLow); };
  const Image image = smoothed(kWidth, kHeight, stair);
  double before = 0, after = 0, sum = 0;
  int between = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 12; x < kWidth - 12; ++x) {
      const double covered = std::clamp(line(x + 0.5) - y, 0.0, 1.0), exact = kLow + covered * (kHigh - kLow);
      const int shown = grey_at(image, x, y);
      before += std::abs(stair(x, y) - exact);
      after += std::abs(shown - exact);
      sum += shown - stair(x, y);
      between += shown > kLow + 8 && shown < kHigh - 8;
    }
  CAPTURE(before, after, sum, between);
  CHECK(after < 0.6 * before);
  CHECK(between > 20);
  CHECK(std::abs(sum) / (kWidth * kHeight) < 1);
}

TEST_CASE("level edges, flat parts and slow gradients stay as they are") {
  const auto context = test::each_context();
  const auto level = [](int, int y) { return std::uint8_t(y < 9 ? 200 : 60); };
  const auto gradient = [](int x, int y) { return std::uint8_t(60 + 2 * x + y); };
  const Image edge = smoothed(40, 20, level), slope = smoothed(40, 20, gradient);
  int changed = 0;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) {
      changed += grey_at(slope, x, y) != gradient(x, y);
      CAPTURE(x, y, grey_at(edge, x, y));
      CHECK(std::abs(grey_at(edge, x, y) - level(x, y)) <= 1);
    }
  CHECK(changed == 0);
}

}  // namespace fascia
