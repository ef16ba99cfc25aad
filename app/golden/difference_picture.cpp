#include "app/golden/difference_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace fascia {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

struct Box {
  int left, top, right, bottom;  // of pixels, inclusive
};

constexpr int kBetween = 4;  // [pixels] between the three pictures
constexpr Pixel kPaper{255, 255, 255, 255}, kFrame{255, 0, 255, 255};

auto at(auto& image, int x, int y) {
  return image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
}

void set(Image& image, int x, int y, const Pixel& pixel) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::copy(pixel.begin(), pixel.end(), at(image, x, y));
}

int largest_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int channel = 0; channel < 4; ++channel) largest = std::max(largest, std::abs(a[channel] - b[channel]));
  return largest;
}

Pixel difference_color(const std::uint8_t* golden, int apart, double bound) {
  if (apart == 0) {
    const auto gray = static_cast<std::uint8_t>((golden[0] + golden[1] + golden[2]) / 12);
    return {gray, gray, gray, 255};
  }
  // Even a difference of one must be visible, so both colors begin bright.
  const double share = apart / 255.0;
  if (share <= bound) return {40, 90, static_cast<std::uint8_t>(160 + 95 * share / bound), 255};
  return {255, static_cast<std::uint8_t>(255 * std::sqrt((share - bound) / (1 - bound))), 0, 255};
}

void draw_frame(Image& image, const Box& box) {
  for (int x = box.left - 2; x <= box.right + 2; ++x) {
    set(image, x, box.top - 2, kFrame);
    set(image, x, box.bottom + 2, kFrame);
  }
  for (int y = box.top - 2; y <= box.bottom + 2; ++y) {
    set(image, box.left - 2, y, kFrame);
    set(image, box.right + 2, y, kFrame);
  }
}

void paste(Image& sheet, const Image& part, int left) {
  for (int y = 0; y < part.height; ++y) {
    const std::uint8_t* row = at(part, 0, y);
    std::copy(row, row + 4 * part.width, at(sheet, left, y));
  }
}

}  // namespace

Image difference_picture(const Image& golden, const Image& now, double bound) {
  Image colored = golden;
  Box box{golden.width, golden.height, -1, -1};
  for (int y = 0; y < golden.height; ++y)
    for (int x = 0; x < golden.width; ++x) {
      const int apart = largest_difference(at(golden, x, y), at(now, x, y));
      set(colored, x, y, difference_color(at(golden, x, y), apart, bound));
      if (apart / 255.0 <= bound) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
  Image sheet;
  sheet.width = 3 * golden.width + 2 * kBetween;
  sheet.height = golden.height;
  sheet.rgba.resize(std::size_t{4} * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  for (int y = 0; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x) set(sheet, x, y, kPaper);
  int left = 0;
  for (const Image* part : {&golden, &now, static_cast<const Image*>(&colored)}) {
    Image framed = *part;
    if (box.right >= 0) draw_frame(framed, box);
    paste(sheet, framed, left);
    left += golden.width + kBetween;
  }
  return sheet;
}

}  // namespace fascia
