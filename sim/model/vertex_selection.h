// Resolves a scene's selection to the vertices of a mesh.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/scene/scene.h"

namespace fascia {

/// [vertex_count] 1 where a tet uses the vertex.
std::vector<char> used_vertices(const std::vector<Tet>& tets, std::size_t vertex_count);

/// What selections select from: a mesh as its file has it, and its usable tets.
struct SelectableMesh {
  const TetMesh& mesh;
  const std::vector<Tet>& tets;
  UpAxis up = UpAxis::y;                     // Body::up
  std::span<const MidEdges> mid_edges = {};  // of the file's quadratic tets, for errors
};

/// Ascending and unique. Positions are those of the file, before the body's placement. Throws Error for a vertex or
/// group that the mesh does not have, and for a selection without a vertex of a tet.
std::vector<std::uint32_t> select_vertices(const Selection& selection, const SelectableMesh& body,
                                           const std::string& where);

}  // namespace fascia
