// RGBA pictures: reads and writes PNG with text metadata, and compares two pictures.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fascia {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // [4 * width * height], top row first
};

using Metadata = std::vector<std::pair<std::string, std::string>>;  // keyword, text

/// From colors premultiplied by alpha, as drawn, to straight ones, as files store them.
void straighten(std::vector<std::uint8_t>& rgba);

/// Writes a PNG with one tEXt/iTXt chunk per metadata entry through a temporary name. Throws Error.
void write_png(const std::filesystem::path& path, const Image& image, const Metadata& metadata = {});
Image read_png(const std::filesystem::path& path);              // throws Error
Metadata read_png_metadata(const std::filesystem::path& path);  // throws Error

struct ImageDifference {
  double mean = 0;   // of absolute channel differences, 0 to 1
  double share = 0;  // of pixels with a channel off by more than `bound`
  Image picture;     // differences, amplified
};
/// Images of different size have differences of 1 and 1.
ImageDifference difference(const Image& a, const Image& b, double bound = 8.0 / 255);

}  // namespace fascia
