// The order in which a solver stores a model's tets and vertices: along a space-filling curve, so that neighbors are
// close in memory for any order of the mesh file. All code outside the solver uses the model's numbering.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/model/model.h"
#include "sim/ordering/tet_pairing.h"

namespace fascia {

struct MeshOrder {
  TetPairing tets;                    // paired_tets(model)
  std::vector<std::uint32_t> vertex;  // [vertex_count] the model's vertex at each place
  std::vector<std::uint32_t> place;   // [vertex_count] place of each of the model's vertices
};

/// Vertices in the order in which the tets reference them; among neighbors, those with equal numbers of tets are
/// adjacent; those without tets come last.
MeshOrder mesh_order_of(const Model& model);
/// The identity: vertices in the model's order.
MeshOrder unmoved(const Model& model);

/// The part of the model that a solver needs, with its vertices numbered by place. Tets keep their order.
Model placed(const Model& model, const MeshOrder& placement);

}  // namespace fascia
