#include "app/session/reproduce.h"

#include <algorithm>
#include <cctype>

#include "app/system/paths.h"
#include "base/error.h"
#include "base/file.h"
#include "base/json/json_document.h"
#include "sim/replay/replay.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The value in the syntax of --set: JSON, or a text that is not JSON.
std::string text_of_value(const OrderedJson& value) {
  if (!value.is_string()) return value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  const std::string text = value.get<std::string>();
  try {
    parse_json(text, "");
  } catch (const Error&) {
    return text;
  }
  return value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

/// Exact comparison: -0 differs from 0.
bool same(const OrderedJson& a, const OrderedJson& b) {
  return a == b && a.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) ==
                       b.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

bool can_be_segment(const std::string& key) { return !key.empty() && key.find_first_of(".[]=") == std::string::npos; }

/// Whether --set can change `from` to `to` key by key.
bool can_descend(const OrderedJson& from, const OrderedJson& to) {
  if (from.is_object() && to.is_object()) {
    for (const auto& item : from.items())
      if (!to.contains(item.key())) return false;
    for (const auto& [key, value] : to.items())
      if (!can_be_segment(key) && (!from.contains(key) || !same(from.at(key), value))) return false;
    return true;
  }
  return from.is_array() && to.is_array() && from.size() == to.size() && !to.empty() && to.front().is_object();
}

void collect(const std::string& path, const OrderedJson& from, const OrderedJson& to, std::vector<std::string>& sets) {
  if (same(from, to)) return;
  if (!path.empty() && !can_descend(from, to)) {
    constexpr std::string_view kFirstBody = "bodies.0.";
    sets.push_back((path.starts_with(kFirstBody) ? path.substr(kFirstBody.size()) : path) + "=" + text_of_value(to));
    return;
  }
  for (const auto& [key, value] : to.items()) {
    const std::string deeper = path.empty() ? key : path + "." + key;
    const OrderedJson* before = nullptr;
    if (from.is_array())
      before = &from.at(static_cast<std::size_t>(std::stoul(key)));
    else if (from.contains(key))
      before = &from.at(key);
    if (before)
      collect(deeper, *before, value, sets);
    else
      collect(deeper, nullptr, value, sets);
  }
}

/// Adds the values that a mesh on its own leaves open, where they equal the defaults: they would be guessed again.
void settle(const Scene& now, std::vector<std::string>& sets) {
  const Body& body = now.bodies.front();
  const OrderedJson document = scene_document(now, now.file.parent_path())["bodies"][0];
  const std::pair<std::string, OrderedJson> values[] = {
      {"unit", name_of(body.unit)},
      {"up", name_of(body.up)},
      {"fixed", document["fixed"]},
      {"materials.default.young_modulus", document["materials"]["default"]["young_modulus"]},
      {"materials.default.model", name_of(body.material.model)}};
  for (const auto& [key, value] : values)
    if (std::none_of(sets.begin(), sets.end(), [&](const std::string& set) { return set.starts_with(key); }))
      sets.push_back(key + "=" + text_of_value(value));
}

}  // namespace

std::vector<std::string> sets_between(const Scene& from, const Scene& to) {
  const std::filesystem::path folder = to.file.parent_path();
  const OrderedJson before = scene_document(from, folder), after = scene_document(to, folder);
  for (const auto& item : before.items())
    if (!after.contains(item.key()))
      throw Error(to.file.string(), "has \"" + item.key() + "\", which no --set takes away", "save the scene instead");
  std::vector<std::string> sets;
  collect("", before, after, sets);
  // If only one of method and acceleration is set, the best matching other one is chosen, not that of the file.
  const bool method = before.at("solver").at("method") != after.at("solver").at("method");
  const bool acceleration = before.at("solver").at("acceleration") != after.at("solver").at("acceleration");
  if (method != acceleration)
    sets.push_back(method ? "solver.acceleration=" + text_of_value(after.at("solver").at("acceleration"))
                          : "solver.method=" + text_of_value(after.at("solver").at("method")));
  return sets;
}

std::string shell_quoted(const std::string& text) {
  constexpr std::string_view kPlain = "_-./:=,+@%";
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [&](unsigned char c) {
    return std::isalnum(c) || kPlain.find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string command_line(const std::filesystem::path& file, const std::vector<std::string>& sets) {
  const std::string path = file.string();
  std::string line = "fascia view " + shell_quoted(path.starts_with('-') ? "./" + path : path);
  for (const std::string& set : sets) line += " --set " + shell_quoted(set);
  return line;
}

std::string command_that_reproduces(const Scene& now) {
  const bool is_replay = lower_ending(now.file) == ".fascia";
  const Scene opened = is_replay ? read_replay(now.file).scene : open_scene(now.file);
  std::vector<std::string> sets = sets_between(opened, now);
  if (opened.unsettled) settle(now, sets);
  return command_line(now.file, sets);
}

}  // namespace fascia
