// Vertices where no mesh should have them: several at one place, at which it comes apart without a gap to be seen, and
// single ones far from all others.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// [vertex_count] the first vertex at exactly the same place.
std::vector<std::uint32_t> first_at_place(const std::vector<Eigen::Vector3d>& positions);

/// How many of the vertices of these tets are at the place of an earlier one of them.
std::size_t count_coincident(const std::vector<Eigen::Vector3d>& positions, const std::vector<Tet>& tets);

/// Makes vertices at one place one, the first of them; the others keep their order. Returns how many are gone.
std::size_t weld(TetMesh& mesh);

/// Ascending vertices of the tets that lie 10,000 times as far out as most: slips of a digit or an exponent, hardly a
/// shape.
std::vector<std::uint32_t> far_vertices(const TetMesh& mesh);

}  // namespace fascia
