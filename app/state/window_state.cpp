#include "app/state/window_state.h"

#include <algorithm>
#include <utility>

#include "sim/mesh/tet_mesh.h"
#include "sim/model/region_materials.h"
#include "sim/output/stats.h"

namespace fascia {

void Statistics::add_steps(double milliseconds, int count, bool compiled, std::vector<double>& all) {
  const double one = milliseconds / count;
  all.insert(all.end(), static_cast<std::size_t>(count), one);
  if (compiled) return;
  for (int i = 0; i < count; ++i) solve.add(one);
  step_ms = step_ms > 0 ? 0.8 * step_ms + 0.2 * one : one;
}

void Statistics::follow_inverted() {
  if (!diagnostics || diagnostics->inverted == 0)
    inverted_since.reset();
  else if (!inverted_since)
    inverted_since = diagnostics->time;
}

SceneFacts::SceneFacts(const Scene& scene, const Model& model)
    : material_volume(model.materials.size(), 0.0), material_names(model.material_names) {
  unit = unit_hint(scene, model);
  const bool one_body = model.bodies.size() == 1;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyPart& part = model.bodies[b];
    std::map<int, Region> found;
    for (std::uint32_t t = part.tet_begin; t < part.tet_begin + part.tet_count; ++t) {
      const Tet& tet = model.tets[t];
      const auto& x = model.rest_positions;
      const double tet_volume = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6;
      material_volume[model.tet_material[t]] += tet_volume;
      volume += tet_volume;
      const int number = model.file_mesh.regions[model.tet_source[t]];
      found.try_emplace(number, Region{b, number, "", "", 0, model.tet_material[t]}).first->second.volume += tet_volume;
    }
    for (auto& [number, region] : found) {
      region.key = key_of_region(part.regions, number);
      const auto named = part.regions.find(number);
      const bool has_name = named != part.regions.end() && !named->second.empty();
      region.label =
          (one_body ? "" : part.name + ": ") + (has_name ? named->second : "region " + std::to_string(number));
      regions.push_back(std::move(region));
    }
  }
  if (!one_body) return;
  for (std::string& name : material_names)
    if (const std::size_t colon = name.find(": "); colon != std::string::npos) name = name.substr(colon + 2);
}

double SceneFacts::mass(const Model& model) const {
  double mass = 0;
  for (std::size_t m = 0; m < material_volume.size(); ++m) mass += material_volume[m] * model.materials[m].density;
  return mass;
}

}  // namespace fascia
