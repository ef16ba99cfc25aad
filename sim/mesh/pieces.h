// The connected pieces of a mesh: tets that share vertices belong together.
#pragma once
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// [vertex_count] the number of each vertex's piece, counted from 0 in the order of the lowest vertices. A vertex in no
/// tet is a piece by itself.
std::vector<std::uint32_t> pieces_of(const std::vector<Tet>& tets, std::size_t vertex_count);

}  // namespace fascia
