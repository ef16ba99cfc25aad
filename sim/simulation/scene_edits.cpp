#include "sim/simulation/scene_edits.h"

#include <vector>

namespace fascia {
namespace {

// Stores only values that differ from the body's default or were given before, so that a saved scene stays short.
void follow(MaterialOverride& values, const Material& now, const Material& fallback) {
  std::vector<double> numbers, defaults;
  visit_material(now, [&](double value, auto&&...) { numbers.push_back(value); });
  visit_material(fallback, [&](double value, auto&&...) { defaults.push_back(value); });
  std::size_t i = 0;
  visit_material(values, [&](std::optional<double>& value, auto&&...) {
    if (value || numbers[i] != defaults[i]) value = numbers[i];
    ++i;
  });
  if (values.model || now.model != fallback.model) values.model = now.model;
  if (values.look || now.look != fallback.look) values.look = now.look;
  if (values.color || now.color != fallback.color) values.color = now.color;
}

}  // namespace

std::vector<MaterialEntries> material_entries(const Scene& scene, const Model& model,
                                              const std::vector<Material>& materials) {
  std::vector<MaterialEntries> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::size_t first = model.bodies[b].material_begin;
    MaterialEntries& entries = all.emplace_back(MaterialEntries{materials[first], scene.bodies[b].region_materials});
    for (std::size_t m = 0; m < entries.region_materials.size(); ++m)
      follow(entries.region_materials[m].second, materials[first + 1 + m], entries.material);
  }
  return all;
}

void follow_materials(Scene& scene, const Model& model, const std::vector<Material>& materials) {
  const std::vector<MaterialEntries> all = material_entries(scene, model, materials);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    scene.bodies[b].material = all[b].material;
    scene.bodies[b].region_materials = all[b].region_materials;
  }
}

}  // namespace fascia
