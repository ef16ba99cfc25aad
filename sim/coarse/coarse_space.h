// Coarse space of the two-level solver: a few hundred smooth functions over the body, made for the mesh. Trilinear hats
// of a lattice over the bounding box, cut apart where the mesh is: a lattice node has one function for each connected
// piece of the mesh in its reach, so that parts that are near in space but far in the mesh, and separate bodies, do not
// move each other. Pieces end at materials, too: a stiff inclusion can turn and shift as a whole, which functions that
// reach into the soft around it could not.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct CoarseSpace {
  std::uint32_t node_count = 0;
  /// P in rows of vertices: entries begin[v] to begin[v + 1] of `node` and `weight`. The weights of a vertex sum to 1;
  /// held vertices and those that no node reaches have none.
  std::vector<std::uint32_t> begin;  // [vertex_count + 1]
  std::vector<std::uint32_t> node;
  std::vector<double> weight;
};

/// About `target` nodes, at most half as many more: of a mesh in very many pieces the lightest have none. Nodes that
/// carry less than a tenth of the mean mass of their part of the mesh are left out: they would make the coarse problem
/// nearly singular. No nodes at all where the mesh has too few vertices to need them.
CoarseSpace make_coarse_space(const Model& model, std::uint32_t target);

/// How many nodes a mesh deserves: dense products with the square of it must stay small beside a pass over the tets.
std::uint32_t coarse_node_target(std::size_t tet_count);

}  // namespace fascia
