#include "sim/accuracy/displacement_rounding.h"

#include <algorithm>
#include <cmath>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/recovered_stress.h"

namespace fascia {

double stress_of_rounding(const Model& model, const State& state) {
  std::vector<double> stresses, volumes;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    double farthest = 0;
    for (const std::uint32_t v : model.element(t)) farthest = std::max(farthest, state.displacement[v].norm());
    const double volume = volume_of(model, t), edge = std::cbrt(6 * std::sqrt(2.0) * volume);
    stresses.push_back(kDisplacementRounding * farthest / edge * model.materials[model.tet_material[t]].young_modulus);
    volumes.push_back(volume);
  }
  return exceeded_by_a_hundredth(stresses, volumes);
}

}  // namespace fascia
