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

void require_own_columns(const Node& contact, const std::vector<std::string>& bodies, const SceneTools& tools) {
  std::map<std::string, std::string> owners;
  if (tools.ground) owners.emplace("ground", "the ground");
  for (const Obstacle& obstacle : tools.obstacles)
    owners.emplace(column_name(obstacle.name), "the obstacle " + excerpt(obstacle.name));
  for (const Instrument& instrument : tools.instruments)
    owners.emplace(column_name(instrument.name), "the instrument " + excerpt(instrument.name));
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a; b < bodies.size(); ++b) {
      if (!(a == b ? tools.contact.self : tools.contact.bodies)) continue;
      const std::string column = column_name(bodies[a]) + "_" + column_name(bodies[b]),
                        owner = a == b ? "the body " + excerpt(bodies[a]) + " with itself"
                                       : "the bodies " + excerpt(bodies[a]) + " and " + excerpt(bodies[b]);
      if (const auto [other, is_new] = owners.try_emplace(column, owner); !is_new)
        contact.fail(owner + " would share the columns contact_" + column + " of histories with " + other->second,
                     "other names");
    }
}

}  // namespace fascia
