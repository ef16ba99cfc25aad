// Distances of the tissue's surface from the tools, for exports.
#pragma once
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// [vertex] signed distance to the nearest tool, less half of the skin's thickness [m]: negative where a tool is
/// deeper. NaN inside the tissue. `places`: [tool of the model].
std::vector<double> contact_gaps(const Model& model, const State& state, const std::vector<ToolPlace>& places);

}  // namespace fascia
