#include "sim/scene/tools/instrument_text.h"

#include <string>

#include "base/json/json_option.h"

namespace fascia {
namespace {

using nlohmann::json;

json taken(json& values, const char* key, json otherwise = {}) {
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
  for (const char* key : {"radius", "center", "half_size", "round", "point", "normal", "file", "scale"})
    if (json value = taken(values, key); !value.is_null()) inner[key] = std::move(value);
  if (json length = taken(values, "length"); !length.is_null()) {
    inner["from"] = {0, 0, 0};
    inner["to"] = {0, std::move(length), 0};
  }
  *shape = {{name, std::move(inner)}};
}

void fold_path(json& values) {
  if (values.contains("path")) return;
  json first = {{"time", taken(values, "start", 0)}};
  for (const auto& [key, target] : {std::pair{"from", "position"}, {"rotate_deg", "rotate_deg"}, {"grip", "grip"}})
    if (json value = taken(values, key); !value.is_null()) first[target] = std::move(value);
  json to = taken(values, "to"), duration = taken(values, "duration", 0);
  json path = json::array({first});
  if (!to.is_null()) {
    json time = duration;
    if (first["time"].is_number() && duration.is_number()) time = first["time"].get<double>() + duration.get<double>();
    if (time == first["time"])
      path[0]["position"] = std::move(to);
    else
      path.push_back({{"time", std::move(time)}, {"position", std::move(to)}});
  }
  values["path"] = std::move(path);
}

}  // namespace

json instrument_document(std::string_view text) {
  json values = json::object();
  const char* example = "name=probe;shape=sphere;radius=0.01;from=0,0.1,0;to=0,0.02,0;duration=1";
  for (const auto& [key, value] : option_parts(text, "--instrument", example))
    values[key] = key == "name" || key == "file" ? json(value) : value_of(value, "--instrument " + key);
  fold_shape(values);
  fold_path(values);
  return values;
}

}  // namespace fascia
