// The vertices in the middle of the edges of quadratic tets.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// A mid-edge vertex and the two ends of its edge.
struct MidEdge {
  std::uint32_t vertex, a, b;
};

/// Makes the given tets of a mesh quadratic, and no others. Those that have mid-edge vertices in `given` ([tet_count]
/// or less) keep them; a vertex is appended, in the order of the tets, to every other edge. Tets that share an edge
/// share its vertex, the first one if they are given different ones. A given vertex is that of one edge, and no corner
/// (require_own_middles).
void add_mid_edges(TetMesh& mesh, const std::vector<std::uint32_t>& tets, const std::vector<MidEdges>& given = {});

/// Moves mid-edge vertices to the middles of their edges. The number of those that were off by more than 1e-6 of the
/// edge.
std::size_t straighten(TetMesh& mesh);

/// Every mid-edge vertex of the mesh once, in the order of the tets.
std::vector<MidEdge> mid_edges_of(const TetMesh& mesh);

/// The mid-edge vertices of a tet whose corners `from` are renumbered as `to`.
MidEdges reordered(const MidEdges& mid_edges, const Tet& from, const Tet& to);

}  // namespace fascia
