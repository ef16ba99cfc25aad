// Quadratic tets as linear ones over the same vertices, for what does not depend on the curves between them: coarse
// functions, boundaries, pictures.
#pragma once
#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct LinearTets {
  std::vector<Tet> tets;
  std::vector<std::uint32_t> source;  // [tets] index into the given tets
};
/// `count` tets from `begin` on, quadratic ones cut in eight. `mid_edges`: [tets], or empty if all are linear.
/// `positions` of all vertices [m].
LinearTets linear_tets(const std::vector<Tet>& tets, const std::vector<MidEdges>& mid_edges,
                       const std::vector<Eigen::Vector3d>& positions, std::size_t begin, std::size_t count);

/// Four tets at the corners and four around the shortest diagonal of the octahedron between them (Bey 1995), of
/// positive volume if the whole has one.
std::array<Tet, 8> cut_in_eight(const Tet& corners, const MidEdges& middles,
                                const std::vector<Eigen::Vector3d>& positions);

}  // namespace fascia
