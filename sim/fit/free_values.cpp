#include "sim/fit/free_values.h"

#include "sim/material/law.h"

namespace fascia {

std::vector<FreeValue> free_values(const Scene& scene, const Model& model) {
  std::vector<FreeValue> values;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    std::vector<std::string> names{"default"};
    for (const auto& entry : scene.bodies[b].region_materials) names.push_back(entry.first);
    for (std::size_t m = 0; m < names.size(); ++m) {
      if (names[m].find('.') != std::string::npos) continue;  // a key is a dotted path
      const std::size_t index = model.bodies[b].material_begin + m;
      const std::string where = (b == 0 ? "" : "bodies." + std::to_string(b) + ".") + "materials." + names[m] + ".";
      visit_material(model.materials[index], [&](double, const char* name, const char* unit, auto&&...) {
        if (reads(model.materials[index].model, name))
          values.push_back({where + name, name, model.material_names[index], unit});
      });
    }
  }
  return values;
}

}  // namespace fascia
