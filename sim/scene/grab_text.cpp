#include "sim/scene/grab_text.h"

#include "base/json/json_option.h"

namespace fascia {
namespace {

using nlohmann::json;

json grab_value(const std::string& key, const std::string& text) {
  if (key == "body") return text;  // a body may be called 2
  if (key != "path" || text.starts_with('[')) return value_of(text, "--grab " + key);
  json keys = json::array();
  for (const std::string& part : parts_of(text, '/')) keys.push_back(list_of(part));
  return keys;
}

}  // namespace

json grab_document(std::string_view text) {
  json document = json::object();
  for (const auto& [key, value] : option_parts(text, "--grab", "at=0.1,0.05,0;translate=0,0.1,0"))
    document[key] = grab_value(key, value);
  return document;
}

}  // namespace fascia
