#include "app/ui/units.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace fascia {
namespace {

constexpr struct {
  char name;
  int exponent;
} kPrefixes[] = {{'p', -12}, {'n', -9}, {'u', -6}, {'m', -3}, {'k', 3}, {'M', 6}, {'G', 9}, {'T', 12}};

bool takes_prefix(const std::string& unit) {
  for (const char* name : {"Pa", "N", "Nm", "J", "m", "m/s", "s", "V"})
    if (unit == name) return true;
  return false;
}

std::string digits_of(double value, int digits) {
  char text[64];
  // Fixed notation if it is readable: 1500 rather than 1.5e+03.
  const double size = std::abs(value);
  if (size >= 1 && size < 1e6 && std::log10(size) >= digits)
    std::snprintf(text, sizeof text, "%.0f", value);
  else
    std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace

std::string engineering(double value, const std::string& unit, int digits) {
  if (!std::isfinite(value)) return "-";
  if (unit.empty()) return digits_of(value, digits);
  if (!takes_prefix(unit) || value == 0) return digits_of(value, digits) + " " + unit;
  // Rounded first, so that 999.9 becomes 1 k and not 1000.
  char rounded[64];
  std::snprintf(rounded, sizeof rounded, "%.*e", digits - 1, value);
  int exponent = std::atoi(std::string_view(rounded).substr(std::string_view(rounded).find('e') + 1).data());
  exponent = std::clamp(static_cast<int>(std::floor(exponent / 3.0)) * 3, -12, 12);
  std::string prefix;
  for (const auto& p : kPrefixes)
    if (p.exponent == exponent) prefix = p.name == 'u' ? "\xc2\xb5" : std::string(1, p.name);
  return digits_of(value / std::pow(10.0, exponent), digits) + " " + prefix + unit;
}

std::optional<double> parse_engineering(std::string text, const std::string& unit) {
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }), text.end());
  if (const std::size_t at = text.find("\xc2\xb5"); at != std::string::npos) text.replace(at, 2, "u");
  const char *begin = text.data() + (text.starts_with('+') ? 1 : 0), *end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  std::string_view suffix(rest, static_cast<std::size_t>(end - rest));
  if (suffix.empty() || suffix == unit) return value;
  if (takes_prefix(unit))
    for (const auto& p : kPrefixes)
      if (suffix.front() == p.name && (suffix.size() == 1 || suffix.substr(1) == unit))
        return value * std::pow(10.0, p.exponent);
  return std::nullopt;
}

std::string bytes_text(double bytes) {
  constexpr const char* kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  int unit = 0;
  for (; bytes >= 1024 && unit < 4; ++unit) bytes /= 1024;
  return digits_of(bytes, 3) + " " + kUnits[unit];
}

}  // namespace fascia
