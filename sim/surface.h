// The triangles that bound a set of tets.
#pragma once
#include <vector>

#include "sim/tet_mesh.h"

namespace fascia {

/// Faces that belong to exactly one tet, wound so that the right-hand normal points outward for tets of
/// positive volume; in ascending order of their tet, so the same input gives the same output.
std::vector<Triangle> boundary_triangles(const std::vector<Tet>& tets);
/// [boundary triangle] the tet that it bounds, in the order of boundary_triangles.
std::vector<std::uint32_t> tets_at_boundary(const std::vector<Tet>& tets);

}  // namespace fascia
