// Finds misplaced vertices: several at one position, where the mesh separates without a visible gap, and single ones
// far from all others.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Throws Error, which begins with `where`, if float32 cannot hold a coordinate.
void require_range(const std::vector<Eigen::Vector3d>& positions, const std::string& where);

/// [vertex_count] the first vertex at exactly the same position.
std::vector<std::uint32_t> first_at_place(const std::vector<Eigen::Vector3d>& positions);

/// The number of these tets' vertices that are at the position of an earlier one of them.
std::size_t count_coincident(const std::vector<Eigen::Vector3d>& positions, const std::vector<Tet>& tets);

/// Merges vertices at one position into the first of them; the others keep their order. Returns the number of removed
/// vertices.
std::size_t weld(TetMesh& mesh);

/// Ascending vertices of the tets that lie 10,000 times as far out as most: more likely a wrong digit or exponent than
/// a shape.
std::vector<std::uint32_t> far_vertices(const TetMesh& mesh);

}  // namespace fascia
