#include "sim/scene/tools/instrument_text.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/json/json_document.h"
#include "base/json/json_node.h"
#include "base/json/json_option.h"
#include "base/suggest.h"
#include "sim/scene/tools/read_tools.h"

namespace fascia {
namespace {

using nlohmann::json;

/// The values that stand beside the name of a shape; all of `needed` must.
struct ShapeKeys {
  std::string name;
  std::vector<std::string> needed, others;

  std::vector<std::string> all() const {
    std::vector<std::string> keys = needed;
    keys.insert(keys.end(), others.begin(), others.end());
    return keys;
  }
};
const std::vector<ShapeKeys> kWords = {
    {"sphere", {"radius"}, {"center"}},
    {"capsule", {"radius", "length"}, {}},
    {"box", {"half_size"}, {"center", "round"}},
    {"plane", {"normal"}, {"point"}},
    {"cylinder", {"radius", "length"}, {"round"}},
    {"mesh", {"file"}, {"scale"}},
};
const std::vector<std::string> kMotionKeys = {"from", "to", "start", "duration", "rotate_deg", "grip"};

std::vector<std::string> values_of_shapes() {
  std::vector<std::string> keys;
  for (const ShapeKeys& shape : kWords)
    for (const std::string& key : shape.all())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

void check_keys(const Node& values) {
  std::vector<std::string> known = {"name", "shape", "jaws", "friction", "path", "interpolate"};
  for (const std::vector<std::string>& more : {kMotionKeys, values_of_shapes()})
    known.insert(known.end(), more.begin(), more.end());
  values.expect_object(known);
}

void check_shape(const Node& values) {
  const auto shape = values.find("shape");
  const ShapeKeys* keys = nullptr;
  if (shape && shape->is_string()) {
    std::vector<std::string> names;
    for (const ShapeKeys& known : kWords) names.push_back(known.name);
    const std::string expected = "one of " + join(names), name = shape->text(expected);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) shape->fail("there is no shape " + excerpt(name) + perhaps(name, names), expected);
    keys = &kWords[static_cast<std::size_t>(found - names.begin())];
  }
  const std::vector<std::string> own = keys ? keys->all() : std::vector<std::string>();
  for (const std::string& key : values_of_shapes()) {
    const auto value = values.find(key);
    if (!value || std::find(own.begin(), own.end(), key) != own.end()) continue;
    if (keys) value->fail("is no value of a " + keys->name, join(own));
    value->fail("goes with the name of a shape", "such as shape=sphere;radius=0.01");
  }
  if (!keys) return;
  for (const std::string& key : keys->needed) values.at(key, "it beside shape=" + keys->name);
  if (const auto length = values.find("length")) length->number(tool_limits::kSmallest, tool_limits::kFarthest, "m");
}

void check_motion(const Node& values) {
  const auto path = values.find("path"), to = values.find("to"), start = values.find("start"),
             duration = values.find("duration");
  if (path) {
    for (const std::string& key : kMotionKeys)
      if (values.find(key)) values.fail("has path and " + key, "one of them");
    return;
  }
  for (const char* key : {"from", "to"})
    if (const auto place = values.find(key)) place->vector(-tool_limits::kFarthest, tool_limits::kFarthest, "m");
  if (start) start->number(0, tool_limits::kLongest, "s");
  if (duration) duration->number(tool_limits::kShortest, tool_limits::kLongest, "s");
  if (to) values.at("duration", "the seconds until it is at to; an instrument that stands has from alone");
  if (duration) values.at("to", "the place [x, y, z] where it is after duration [m]");
  if (start) values.at("to", "the place [x, y, z] to which it moves from start on [m]");
  if (!to && (values.find("shape") || values.find("jaws")))
    values.at("from", "the place [x, y, z] where it stands [m], or from, to and duration");
}

json taken(json& values, const std::string& key, json otherwise = {}) {
  const auto found = values.find(key);
  if (found == values.end()) return otherwise;
  json value = std::move(*found);
  values.erase(found);
  return value;
}

// The values of a shape that stand beside its name move into it.
void fold_shape(json& values) {
  const auto shape = values.find("shape");
  if (shape == values.end() || !shape->is_string()) return;
  const std::string name = *shape;
  json inner = json::object();
  if (json length = taken(values, "length"); !length.is_null()) {
    inner["from"] = {0, 0, 0};
    inner["to"] = {0, std::move(length), 0};
  }
  for (const std::string& key : values_of_shapes())
    if (json value = taken(values, key); !value.is_null()) inner[key] = std::move(value);
  *shape = {{name, std::move(inner)}};
}

void fold_path(json& values) {
  if (values.contains("path")) return;
  json first = {{"time", taken(values, "start", 0)}};
  for (const auto& [key, target] : {std::pair{"from", "position"}, {"rotate_deg", "rotate_deg"}, {"grip", "grip"}})
    if (json value = taken(values, key); !value.is_null()) first[target] = std::move(value);
  json path = json::array({first});
  if (json to = taken(values, "to"); !to.is_null()) {
    const double end = first["time"].get<double>() + taken(values, "duration").get<double>();
    path.push_back({{"time", end}, {"position", std::move(to)}});
  }
  values["path"] = std::move(path);
}

}  // namespace

json instrument_document(std::string_view text) {
  json values = json::object();
  const char* example = "name=probe;shape=sphere;radius=0.01;from=0,0.1,0;to=0,0.02,0;duration=1";
  for (const auto& [key, value] : option_parts(text, "--instrument", example))
    values[key] = key == "name" || key == "file" ? json(value) : value_of(value, "--instrument " + key);
  const DocumentOrigin origin{"--instrument", {}};
  const Node given(values, "", origin);
  check_keys(given);
  check_shape(given);
  check_motion(given);
  fold_shape(values);
  fold_path(values);
  return values;
}

}  // namespace fascia
