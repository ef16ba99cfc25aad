// The middle vertices of quadratic tets by their places: programs that write a format in the order of another one have
// each of them at another edge.
#pragma once
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Throws Error, which begins with `where`, if a given middle vertex of the tets ([tet_count] or less) belongs to two
/// edges or is a corner.
void require_own_middles(const TetMesh& mesh, const std::vector<std::uint32_t>& tets,
                         const std::vector<MidEdges>& given, const std::string& where);

/// Puts the given middle vertices of the tets ([tet_count] or less) in the order of kMidEdgeCorners where they lie at
/// the tet's edges in another one, and returns the number of these tets. Vertices of curved edges stay where they are:
/// they are nearest to their own edge's middle. Throws Error, which begins with `where`, if one lies farther from that
/// than half of the tet's longest edge.
std::size_t order_mid_edges(const TetMesh& mesh, const std::vector<std::uint32_t>& tets, std::vector<MidEdges>& given,
                            const std::string& where);

}  // namespace fascia
