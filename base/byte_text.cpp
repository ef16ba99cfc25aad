#include "base/byte_text.h"

#include <array>
#include <cstdint>

namespace fascia {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t not_a_digit = 255;

constexpr std::array<std::uint8_t, 256> make_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(not_a_digit);
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  return values;
}
constexpr std::array<std::uint8_t, 256> values = make_values();

}  // namespace

std::string base64_encoded(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? alphabet[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::optional<Base64> base64_decoded(std::string_view text, std::size_t most) {
  Base64 out{{}, 0};
  out.bytes.reserve(text.size() / 4 * 3 < most ? text.size() / 4 * 3 : most);
  std::uint32_t group = 0;
  int digits = 0, padding = 0;
  for (std::size_t i = 0; i < text.size() && out.bytes.size() < most; ++i) {
    const char c = text[i];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const std::uint8_t value = values[static_cast<unsigned char>(c)];
    if (c == '=') {
      ++padding;
    } else if (value == not_a_digit || padding > 0) {
      return std::nullopt;
    }
    group = group << 6 | (c == '=' ? 0u : value);
    if (++digits < 4) continue;
    if (padding > 2) return std::nullopt;
    for (int k = 0; k < 3 - padding; ++k) out.bytes += static_cast<char>(group >> (16 - 8 * k) & 255);
    out.used = i + 1;
    group = 0;
    digits = padding = 0;
  }
  if (digits != 0) return std::nullopt;
  return out;
}

}  // namespace fascia
