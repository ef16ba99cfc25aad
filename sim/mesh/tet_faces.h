// The faces of a set of tets: the boundary triangles, and the neighbor across each inner face.
#pragma once
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Faces that belong to exactly one tet, wound so that the right-hand normal points outward for tets of positive
/// volume; in ascending order of their tet, so the same input gives the same output.
std::vector<Triangle> boundary_triangles(const std::vector<Tet>& tets);
/// [boundary triangle] its tet, in the order of boundary_triangles.
std::vector<std::uint32_t> tets_at_boundary(const std::vector<Tet>& tets);

constexpr std::uint32_t kNoTet = ~0u;
/// [4 * tet_count] the tet across the face opposite to each corner; kNoTet where there is none, or more than one.
std::vector<std::uint32_t> tets_across_faces(const std::vector<Tet>& tets);

}  // namespace fascia
