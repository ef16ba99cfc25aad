#include "sim/scene/tools/scene_names.h"

#include <algorithm>

#include "base/json/json_document.h"

namespace fascia {

void SceneNames::claim(const Node& node, const std::string& name, const std::string& owner) {
  if (name.empty()) node.fail("has an empty name", "a name, which statistics use");
  const auto [entry, is_new] = owners_.try_emplace(column_name(name), owner);
  if (!is_new) node.fail(excerpt(name) + " is the name of " + entry->second, "a name of its own, which statistics use");
}

std::string SceneNames::give(const std::string& wanted, const std::string& owner) {
  std::string name = wanted;
  for (int number = 2; !owners_.try_emplace(column_name(name), owner).second; ++number)
    name = wanted + " " + std::to_string(number);
  return name;
}

std::string column_name(const std::string& name) {
  std::string column = name;
  std::replace_if(
      column.begin(), column.end(), [](char c) { return c == ',' || c == '\n' || c == '\r'; }, '_');
  return column;
}

}  // namespace fascia
