#include "app/cli/scene_keys.h"

#include <algorithm>
#include <set>

#include "sim/material/material.h"
#include "sim/material/tissue_looks.h"
#include "sim/scene/scene_write.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {
namespace {

void collect(const nlohmann::ordered_json& node, const std::string& path, std::vector<SceneKey>& keys) {
  if (!node.is_object()) {
    keys.push_back({path, {}});
    return;
  }
  for (const auto& [key, value] : node.items()) {
    if (key == "bodies")
      collect(value[0], "", keys);
    else
      collect(value, path.empty() ? key : path + "." + key, keys);
  }
}

template <class Values>
std::vector<std::string> names_of(const Values& values) {
  std::vector<std::string> names;
  for (const auto value : values) names.push_back(name_of(value));
  return names;
}

// The values of a display setting; empty: numbers.
template <class Field>
std::vector<std::string> values_of(const Field&) {
  return {};
}
std::vector<std::string> values_of(bool) { return {"true", "false"}; }
std::vector<std::string> values_of(ColorBy) { return names_of(all_colors()); }
std::vector<std::string> values_of(ColorMap) { return names_of(all_color_maps()); }
std::vector<std::string> values_of(Background) { return names_of(all_backgrounds()); }
std::vector<std::string> values_of(const MarkSettings&) { return {"true", "false"}; }

}  // namespace

std::vector<SceneKey> scene_keys() {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].surface = "surface.obj";
  scene.bodies[0].material.look = &tissue_looks().front();
  scene.bodies[0].material.color = {0, 0, 0};
  scene.bodies[0].unit = LengthUnit::mm;  // not written where they have no effect
  scene.bodies[0].up = UpAxis::z;
  scene.camera.emplace();
  scene.display.range.emplace(0, 1);
  std::vector<SceneKey> keys;
  collect(scene_document(scene, ""), "", keys);
  std::erase_if(keys, [](const SceneKey& key) { return key.name == "fascia_scene"; });

  std::set<std::string> methods, accelerations;
  for (const SolverChoice& pair : solver_choices()) {
    methods.insert(name_of(pair.method));
    accelerations.insert(name_of(pair.acceleration));
  }
  for (SceneKey& key : keys) {
    if (key.name == "unit") key.values = names_of(kLengthUnits);
    if (key.name == "up") key.values = names_of(kUpAxes);
    if (key.name == "solver.method") key.values.assign(methods.begin(), methods.end());
    if (key.name == "solver.acceleration") key.values.assign(accelerations.begin(), accelerations.end());
    visit_display(scene.display, [&](const auto& field, const std::string& name, auto&&...) {
      if (key.name == "display." + name) key.values = values_of(field);
    });
    if (key.name == "display.legend.side") key.values = names_of(all_legend_sides());
    if (key.name == "display.legend.plate") key.values = {"true", "false"};
    if (key.name == "materials.default.model") key.values = names_of(material_models());
    if (key.name == "materials.default.look") key.values = look_names();
  }
  return keys;
}

}  // namespace fascia
