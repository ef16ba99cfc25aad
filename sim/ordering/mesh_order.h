// Where a solver keeps a model's tets and vertices: along a space-filling curve, so that what a kernel reads of
// neighbors lies close together whatever order the mesh file had. Everything outside of the solver counts vertices as
// the model does.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/model/model.h"
#include "sim/ordering/tet_pairing.h"

namespace fascia {

struct MeshOrder {
  TetPairing tets;                    // paired_tets(model)
  std::vector<std::uint32_t> vertex;  // [vertex_count] the model's vertex at each place
  std::vector<std::uint32_t> place;   // [vertex_count] of each of the model's vertices
};

/// Vertices in the order in which the tets meet them, then, among neighbors, those with as many tets side by side;
/// those with none come last.
MeshOrder mesh_order_of(const Model& model);
/// Vertices where they are in the model.
MeshOrder unmoved(const Model& model);

/// What of the model a solver needs, with its vertices counted by their places. Tets keep their order.
Model placed(const Model& model, const MeshOrder& placement);

}  // namespace fascia
