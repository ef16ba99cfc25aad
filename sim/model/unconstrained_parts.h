// The unconstrained components of a model: tets connected through shared vertices, none of which is fixed or
// prescribed.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct UnconstrainedParts {
  std::size_t parts = 0, vertices = 0;
  std::uint32_t first = 0;          // the first vertex in them
  std::size_t held_parts = 0;       // constrained components
  std::vector<std::uint32_t> part;  // [vertex_count] number of the unconstrained component, from 1; else 0
};
/// `held` [vertex_count]: 1 for constrained vertices.
UnconstrainedParts unconstrained_parts(const Model& model, const std::vector<char>& held);

/// "vertex 12 of beam", numbered as in the body's file.
std::string vertex_name(const Model& model, std::uint32_t vertex);

/// A note about unconstrained components that gravity accelerates away from a model with supports; "" if there are
/// none. A component that a grab of the scene pulls does not count, nor a model that falls as a whole.
std::string note_of_unconstrained_parts(const Model& model);

}  // namespace fascia
