#include "base/json/json_option.h"

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "base/json/json_document.h"

namespace fascia {

using nlohmann::json;

std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

std::vector<std::pair<std::string, std::string>> option_parts(std::string_view text, const std::string& option,
                                                              const std::string& example) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const std::string& part : parts_of(text, ';')) {
    const std::size_t begin = part.find_first_not_of(' '), equals = part.find('=');
    if (begin == std::string::npos) continue;
    if (equals == std::string::npos || equals == begin)
      throw Error(option, on_one_line(part) + " is not KEY=VALUE", "expected such as " + example);
    const std::string key = part.substr(begin, equals - begin);
    if (std::any_of(result.begin(), result.end(), [&](const auto& other) { return other.first == key; }))
      throw Error(option, on_one_line(key) + " is given twice", "expected each key once");
    result.emplace_back(key, part.substr(equals + 1));
  }
  return result;
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  if (text.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return std::nullopt;
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

json scalar_of(const std::string& text) {
  try {
    const json value = parse_json(text, "");
    if (value.is_primitive()) return value;
  } catch (const Error&) {
    if (const std::optional<double> number = number_in(text)) return *number;
  }
  return text;
}

json list_of(const std::string& text) {
  json values = json::array();
  for (const std::string& part : parts_of(text, ',')) values.push_back(scalar_of(part));
  return values;
}

json value_of(const std::string& text, const std::string& option) {
  if (text.starts_with('{') || text.starts_with('[')) return parse_json(text, option);
  return text.find(',') == std::string::npos ? scalar_of(text) : list_of(text);
}

}  // namespace fascia
