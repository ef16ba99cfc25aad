#include "app/golden/tolerance.h"

#include <charconv>
#include <cstdio>
#include <optional>

#include "base/error.h"
#include "base/json/json_document.h"

namespace fascia {
namespace {

std::optional<double> number(std::string_view text) {
  double value;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

double parse_tolerance(std::string_view text, const std::string& where) {
  const std::size_t slash = text.find('/');
  const std::optional<double> above = number(text.substr(0, slash));
  const std::optional<double> below = slash == std::string_view::npos ? 1.0 : number(text.substr(slash + 1));
  const double value = above && below && *below > 0 ? *above / *below : -1;
  if (!(value >= 0 && value <= 1))
    throw Error(where, "is " + on_one_line(text), "expected a share from 0 to 1, such as 0.002 or 0.5/255");
  return value;
}

std::string three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace fascia
