// The quadratic tets of a model on a finer mesh: each cut in eight, quadratic again.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/mesh/mid_edges.h"
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

struct RefinedModel {
  Model model;  // the vertices of the coarse one come first; held vertices are fixed, and loads are left out
  State state;  // the displacements of the coarse tets at all vertices
  std::vector<std::uint32_t> tets;           // the quadratic ones of the coarse model
  std::vector<std::uint32_t> first_of;       // [tet of the coarse model] the first of its eight
  std::vector<MidEdge> coarse_edges, edges;  // of the quadratic tets and of the finer ones
  std::vector<char> held;                    // [vertex]
};

RefinedModel refined(const Model& coarse, const State& state);

/// Barycentric coordinates of a vertex of a quadratic tet.
Eigen::Vector4d place_in(const ElementVertices& element, std::uint32_t vertex);

}  // namespace fascia
