#include "sim/scene/grab_text.h"

#include "base/json/json_node.h"
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

/// What a scene file may have, and would do nothing.
void check_words(const Node& grab) {
  if (const auto body = grab.find("body"); body && body->text("").empty()) body->refuse("the name of a body");
  const bool moves = grab.find("translate") || grab.find("push") || grab.find("path");
  for (const char* key : {"duration", "smooth"})
    if (const auto value = grab.find(key); value && !moves) value->fail("has no motion", "it beside translate or push");
}

}  // namespace

json grab_document(std::string_view text) {
  json document = json::object();
  for (const auto& [key, value] : option_parts(text, "--grab", "at=0.1,0.05,0;translate=0,0.1,0"))
    document[key] = grab_value(key, value);
  const DocumentOrigin origin{"--grab", {}};
  check_words(Node(document, "", origin));
  return document;
}

}  // namespace fascia
