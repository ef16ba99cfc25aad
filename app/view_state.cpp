#include "app/view_state.h"

#include <algorithm>

#include "sim/tet_mesh.h"

namespace fascia {

void History::add(double value) {
  values_[next_] = static_cast<float>(value);
  next_ = (next_ + 1) % values_.size();
  count_ = std::min(count_ + 1, values_.size());
}

double History::mean() const {
  const int n = std::min(count(), 30);
  double sum = 0;
  for (int i = count() - n; i < count(); ++i) sum += at(i);
  return n ? sum / n : 0;
}

SceneFacts::SceneFacts(const Model& model) : material_volume(model.materials.size(), 0.0), material_names(model.material_names) {
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    const auto& x = model.rest_positions;
    material_volume[model.tet_material[t]] += signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6;
  }
  if (model.bodies.size() > 1) return;
  for (std::string& name : material_names)
    if (const std::size_t colon = name.find(": "); colon != std::string::npos) name = name.substr(colon + 2);
}

double SceneFacts::mass(const Model& model) const {
  double mass = 0;
  for (std::size_t m = 0; m < material_volume.size(); ++m) mass += material_volume[m] * model.materials[m].density;
  return mass;
}

}  // namespace fascia
