// The coarse space of the two-level solver: a few hundred smooth functions over the body, generated for the mesh. They
// are trilinear hats of a lattice over the bounding box, split where the mesh is: a lattice node has one function for
// each connected piece of the mesh in its support, so that separate bodies, and parts that are close in space but far
// apart in the mesh, do not move each other. Pieces also end at material boundaries: a stiff inclusion can then rotate
// and translate as a whole, which functions that extend into the soft surroundings do not permit.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct CoarseSpace {
  std::uint32_t node_count = 0;
  /// P by rows of vertices: entries begin[v] to begin[v + 1] of `node` and `weight`. The weights of a vertex sum to 1;
  /// constrained vertices and vertices outside every node's support have none.
  std::vector<std::uint32_t> begin;  // [vertex_count + 1]
  std::vector<std::uint32_t> node;
  std::vector<double> weight;
};

/// About `target` nodes, at most half as many more: if the mesh has very many pieces, the lightest have no node. Nodes
/// that carry less than a tenth of the mean mass of their part of the mesh are left out because they would make the
/// coarse problem nearly singular. A mesh with too few vertices to need a coarse space gets no nodes.
CoarseSpace make_coarse_space(const Model& model, std::uint32_t target);

/// The suitable number of nodes for a mesh: dense products with its square must stay cheap beside a pass over the tets.
std::uint32_t coarse_node_target(std::size_t tet_count);

}  // namespace fascia
