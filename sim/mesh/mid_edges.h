// The vertices in the middle of the edges of quadratic tets.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// A mid-edge vertex and the two ends of its edge.
struct MidEdge {
  std::uint32_t vertex, a, b;
};

/// Makes the given tets of a mesh quadratic: appends a vertex in the middle of each of their edges, in the order of the
/// tets. Tets that share an edge share its vertex.
void add_mid_edges(TetMesh& mesh, const std::vector<std::uint32_t>& tets);

/// Every mid-edge vertex of the mesh once, in the order of the tets.
std::vector<MidEdge> mid_edges_of(const TetMesh& mesh);

/// The mid-edge vertices of a tet whose corners `from` are renumbered as `to`.
MidEdges reordered(const MidEdges& mid_edges, const Tet& from, const Tet& to);

}  // namespace fascia
