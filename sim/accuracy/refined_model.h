// The tets of one kind of a model with more freedom: linear ones become quadratic, quadratic ones are cut in eight.
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
  std::vector<std::uint32_t> tets;           // those of the coarse model
  std::vector<std::uint32_t> first_of;       // [tet of the coarse model] the first of the finer ones in its place
  std::size_t parts = 1;                     // finer tets in the place of one
  std::vector<MidEdge> coarse_edges, edges;  // of the coarse tets and of the finer ones
  std::vector<char> held;                    // [vertex]
};

RefinedModel refined(const Model& coarse, const State& state, ElementOrder kind);

/// Barycentric coordinates of a vertex of a tet.
Eigen::Vector4d place_in(const ElementVertices& element, std::uint32_t vertex);

}  // namespace fascia
