// The stress of rounding against that of states that are rounded.
#include "sim/accuracy/displacement_rounding.h"

#include <catch2/catch.hpp>

#include "sim/accuracy/nodal_stress.h"
#include "tests/support/models.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("displacements that are rounded have less stress than that of rounding, and deformed ones have more") {
  const bool quadratic = GENERATE(false, true);
  Material material;
  material.young_modulus = 1e5;
  Model model = test::make_model(make_box(3, 2, 2, {0.3, 0.2, 0.2}), material, [](const Vector3d&) { return false; });
  if (quadratic) model = test::quadratic(model);
  for (const double distance : {0.1, 10.0}) {
    State state = initial_state(model);
    const auto move_by = [&](double stretch) {
      for (std::size_t v = 0; v < state.displacement.size(); ++v)
        state.displacement[v] = float32_of(distance * Vector3d(1, 0.3, -0.7) + stretch * model.rest_positions[v]);
    };
    move_by(0);
    for (std::size_t v = 0; v < state.displacement.size(); ++v)  // every other vertex is off by a last place
      if (v % 2 == 0) state.displacement[v] = float32_of((1 + 0x1p-23) * state.displacement[v]);
    const double rounded = peak_of(nodal_stress(model, state), model).p99, bound = stress_of_rounding(model, state);
    CAPTURE(quadratic, distance, rounded, bound);
    CHECK(rounded > 0);
    CHECK(rounded < bound);
    CHECK(peak_beyond_rounding(model, state) == 0);
    for (std::size_t v = 0; v < state.displacement.size(); ++v)
      state.displacement[v].x() += 0.01 * model.rest_positions[v].x();
    CHECK(peak_beyond_rounding(model, state) == peak_of(nodal_stress(model, state), model).p99);
    CHECK(peak_beyond_rounding(model, state) > 700);
  }
}
