// The elements of an open scene's bodies, linear or quadratic tets, and its state with others.
#pragma once
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// "elements" of every body of a scene [bodies].
using ElementOrders = std::vector<ElementOrder>;

ElementOrders elements_of(const Scene& scene);

/// The state of one model in another of the same bodies, in which some have other elements. Vertices in the middle of
/// edges that are added lie in their middles; the state before the last step is left out.
State with_elements(const State& state, const Model& from, const Model& to);

}  // namespace fascia
