// The error of displacements that fascia estimates.
#pragma once
#include <cmath>

#include "sim/accuracy/recovered_stress.h"
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia::test {

/// Root of the integrals of squares, against a finer mesh whose first vertices are the model's.
inline double error_against(const Model& model, const State& state, const State& finer) {
  double distance = 0, whole = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.tets[t]) {
      distance += volume_of(model, t) * (state.displacement[v] - finer.displacement[v]).squaredNorm();
      whole += volume_of(model, t) * finer.displacement[v].squaredNorm();
    }
  return std::sqrt(distance / whole);
}

}  // namespace fascia::test
