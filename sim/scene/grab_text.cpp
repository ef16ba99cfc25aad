#include "sim/scene/grab_text.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "base/json/json_document.h"

namespace fascia {
namespace {

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

// A number, true, false, or the text itself.
json scalar(const std::string& text) {
  try {
    const json value = parse_json(text, "");
    if (value.is_primitive()) return value;
  } catch (const Error&) {
  }
  return text;
}

json list(const std::string& text) {
  json values = json::array();
  for (const std::string& part : parts_of(text, ',')) values.push_back(scalar(part));
  return values;
}

json value_of(const std::string& key, const std::string& text) {
  if (key == "body") return text;  // a body may be called 2
  if (text.starts_with('{') || text.starts_with('[')) return parse_json(text, "--grab " + key);
  if (key == "path") {
    json keys = json::array();
    for (const std::string& part : parts_of(text, '/')) keys.push_back(list(part));
    return keys;
  }
  return text.find(',') == std::string::npos ? scalar(text) : list(text);
}

}  // namespace

json grab_document(std::string_view text) {
  json document = json::object();
  for (const std::string& part : parts_of(text, ';')) {
    const std::size_t begin = part.find_first_not_of(' '), equals = part.find('=');
    if (begin == std::string::npos) continue;
    if (equals == std::string::npos || equals == begin)
      throw Error("--grab", on_one_line(part) + " is not KEY=VALUE",
                  "expected such as at=0.1,0.05,0;translate=0,0.1,0");
    const std::string key = part.substr(begin, equals - begin);
    if (document.contains(key)) throw Error("--grab", on_one_line(key) + " is given twice", "expected each key once");
    document[key] = value_of(key, part.substr(equals + 1));
  }
  return document;
}

}  // namespace fascia
