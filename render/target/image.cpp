// Reads and writes PNG. stb handles the pixels; the chunks around them are read and written here because stb neither
// checks a PNG's checksums nor supports text.
#include "render/target/image.h"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "base/error.h"
#include "base/file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace fascia {
namespace {

constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::size_t kHeaderEnd = 33;  // signature and IHDR chunk

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(checksum(type + data));
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; });
}

std::string text_chunk(const std::string& keyword, const std::string& text) {
  if (is_ascii(text)) return chunk("tEXt", keyword + '\0' + text);
  // Not compressed, no language, no translated keyword, then UTF-8.
  return chunk("iTXt", keyword + std::string(5, '\0') + text);
}

void check_text(const std::filesystem::path& path, const std::string& keyword, const std::string& text) {
  if (keyword.empty() || keyword.size() > 79 ||
      !std::all_of(keyword.begin(), keyword.end(), [](unsigned char c) { return c >= 0x20 && c < 0x7f; }))
    throw Error(path.string(), "metadata keyword '" + keyword + "'", "expected 1 to 79 printable ASCII characters");
  if (text.find('\0') != std::string::npos)
    throw Error(path.string(), "metadata " + keyword + " contains a zero byte", "expected text");
}

std::string utf8_of_latin1(std::string_view text) {
  std::string result;
  for (const char byte : text) {
    const auto c = static_cast<unsigned char>(byte);
    if (c < 0x80) {
      result += byte;
    } else {
      result += static_cast<char>(0xc0 | c >> 6);
      result += static_cast<char>(0x80 | (c & 0x3f));
    }
  }
  return result;
}

struct Chunk {
  std::string_view type, data;
};

/// Every chunk up to IEND, with lengths and checksums verified.
std::vector<Chunk> chunks_of(const std::filesystem::path& path, std::string_view file) {
  const auto bad = [&](const std::string& what) { return Error(path.string(), what, "expected a PNG picture"); };
  if (file.substr(0, kSignature.size()) != kSignature) throw bad("no PNG signature");
  std::vector<Chunk> chunks;
  for (std::size_t at = kSignature.size(); chunks.empty() || chunks.back().type != "IEND";) {
    if (file.size() - at < 12) throw bad("truncated at byte " + std::to_string(file.size()));
    const std::size_t length = big_endian(file.substr(at, 4));
    if (length > file.size() - at - 12)
      throw bad("chunk at byte " + std::to_string(at) + " claims " + std::to_string(length) + " bytes, " +
                std::to_string(file.size() - at - 12) + " are left");
    if (checksum(file.substr(at + 4, length + 4)) != big_endian(file.substr(at + 8 + length, 4)))
      throw bad("wrong checksum in the chunk at byte " + std::to_string(at));
    chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, length)});
    at += 12 + length;
  }
  if (chunks.front().type != "IHDR" || chunks.front().data.size() != 13) throw bad("no IHDR chunk at its start");
  return chunks;
}

}  // namespace

void straighten(std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const int alpha = rgba[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t c = i; c < i + 3; ++c)
      rgba[c] = static_cast<std::uint8_t>(std::min(255, (255 * rgba[c] + alpha / 2) / alpha));
  }
}

void write_png(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
  const std::size_t pixels =
      static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0));
  if (pixels == 0 || image.rgba.size() != 4 * pixels)
    throw Error(path.string(),
                "picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " with " +
                    std::to_string(image.rgba.size()) + " bytes",
                "expected 4 bytes for each pixel, and at least one pixel");
  std::string texts;
  for (const auto& [keyword, text] : metadata) {
    check_text(path, keyword, text);
    texts += text_chunk(keyword, text);
  }
  int length = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> png(
      stbi_write_png_to_mem(image.rgba.data(), 4 * image.width, image.width, image.height, 4, &length), std::free);
  if (!png) throw Error(path.string(), "no memory to write a picture", "expected a smaller picture");
  const std::string_view content(reinterpret_cast<const char*>(png.get()), static_cast<std::size_t>(length));
  write_file(path, std::string(content.substr(0, kHeaderEnd)) + texts + std::string(content.substr(kHeaderEnd)));
}

Image read_png(const std::filesystem::path& path) {
  const std::string file = read_file(path);
  const std::vector<Chunk> chunks = chunks_of(path, file);
  const std::uint64_t width = big_endian(chunks.front().data), height = big_endian(chunks.front().data.substr(4));
  // Deflate cannot expand data by more than 1032, and a pixel has at least one bit: a header that claims more is
  // invalid.
  constexpr std::uint64_t kMostPixels = 1 << 26, kMostBytes = 1 << 30;
  if (width == 0 || height == 0 || width > kMostPixels / height || file.size() > kMostBytes ||
      width * height / 8 > 1032 * file.size())
    throw Error(path.string(),
                "claims " + std::to_string(width) + " x " + std::to_string(height) + " pixels in " +
                    std::to_string(file.size()) + " bytes",
                "expected a PNG picture");
  int w = 0, h = 0, channels = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), static_cast<int>(file.size()), &w, &h,
                            &channels, 4),
      std::free);
  if (!pixels)
    throw Error(path.string(), std::string("cannot be decoded: ") + stbi_failure_reason(), "expected a PNG picture");
  Image image{w, h, {}};
  image.rgba.assign(pixels.get(), pixels.get() + 4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  return image;
}

Metadata read_png_metadata(const std::filesystem::path& path) {
  const std::string file = read_file(path);
  Metadata metadata;
  for (const Chunk& chunk : chunks_of(path, file)) {
    const std::size_t end = chunk.data.find('\0');
    if (end == std::string_view::npos) continue;
    const std::string keyword = utf8_of_latin1(chunk.data.substr(0, end));
    const std::string_view rest = chunk.data.substr(end + 1);
    if (chunk.type == "tEXt") metadata.emplace_back(keyword, utf8_of_latin1(rest));
    if (chunk.type != "iTXt" || rest.empty() || rest[0] != 0) continue;  // compressed text is not written by fascia
    const std::size_t language_end = rest.find('\0', 2);
    if (language_end == std::string_view::npos) continue;
    const std::size_t translation_end = rest.find('\0', language_end + 1);
    if (translation_end == std::string_view::npos) continue;
    metadata.emplace_back(keyword, std::string(rest.substr(translation_end + 1)));
  }
  return metadata;
}

ImageDifference difference(const Image& a, const Image& b, double bound) {
  if (a.width != b.width || a.height != b.height || a.rgba.empty()) return {1, 1, {}};
  constexpr int kAmplification = 8;
  ImageDifference result;
  result.picture = {a.width, a.height, std::vector<std::uint8_t>(a.rgba.size())};
  std::uint64_t sum = 0, off = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int most = 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const int apart = std::abs(a.rgba[pixel + channel] - b.rgba[pixel + channel]);
      sum += static_cast<std::uint64_t>(apart);
      most = std::max(most, apart);
      result.picture.rgba[pixel + channel] = static_cast<std::uint8_t>(std::min(kAmplification * apart, 255));
    }
    result.picture.rgba[pixel + 3] = 255;
    if (most / 255.0 > bound) ++off;
  }
  result.mean = static_cast<double>(sum) / 255 / static_cast<double>(a.rgba.size());
  result.share = static_cast<double>(off) / static_cast<double>(a.rgba.size() / 4);
  return result;
}

}  // namespace fascia
