// What rounding of displacements to float32 leaves in bodies that are not deformed: errors relative to it would be
// rounding over rounding.
#pragma once
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// Of a displacement, in those of neighbors: half a unit in the last place each, times what steps add up. Bodies that
/// fall freely have up to a quarter of it.
inline constexpr double kDisplacementRounding = 0x1p-19;

/// The von Mises stress that 1 % of the volume exceeds [Pa] where neighbors move apart by that rounding.
double stress_of_rounding(const Model& model, const State& state);

}  // namespace fascia
