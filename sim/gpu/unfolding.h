// Starts that are inside out. A law with a logarithm of the volume ratio resists compression ever more, and keeps a
// body that starts crumpled in one of many tangles, in which every tet is upright. signed_st_venant_kirchhoff, whose
// resistance stays small, unfolds it: for the first steps of such a start the GPU solver takes that law in place of
// neo_hookean, mooney_rivlin and squared.
#pragma once
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

inline constexpr double kLongestUnfolding = 2;  // [s]; a body that cannot unfold has its own law from then on
inline constexpr int kUnfoldingInterval = 8;    // steps between two looks at the state

/// Whether the model has such a law and a tenth of its tets have no positive volume. States that a law itself
/// leads to have far fewer, if any.
bool needs_unfolding(const Model& model, const State& state);
bool is_unfolded(const Model& model, const State& state);  // no tet is below 0.3 of its volume
void take_unfolding_law(std::vector<Material>& materials);

}  // namespace fascia
