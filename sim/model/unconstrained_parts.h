// Parts of a model that nothing holds: tets connected over shared vertices, of which none is fixed or prescribed.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct UnconstrainedParts {
  std::size_t parts = 0, vertices = 0;
  std::uint32_t first = 0;                   // the first of these vertices
  std::size_t held_parts = 0;                // the others
  std::vector<std::uint32_t> unconstrained;  // [vertex_count] 1 in these parts
};
/// `held` [vertex_count] 1 where something holds a vertex.
UnconstrainedParts unconstrained_parts(const Model& model, const std::vector<char>& held);

/// "vertex 12 of beam", counted as in the body's file.
std::string vertex_name(const Model& model, std::uint32_t vertex);

/// Tells of parts that gravity takes away from a model that is held elsewhere; "" if there are none. A part that a grab
/// of the scene holds does not count, nor a model that falls as a whole.
std::string note_of_unconstrained_parts(const Model& model);

}  // namespace fascia
