// How far a state is from that of an infinitely fine mesh under the same forces, estimated from the state alone: by
// the distance to a finer solution (sim/accuracy/finer_solution.h), whose stress T* stands beside T of the tets.
//
// Where there is no finer solution, or the tets are too many for it, T* is recovered by patches
// (sim/accuracy/recovered_stress.h), and the estimate is w over int T* : D^-1 T* (Zienkiewicz, Zhu 1987), with theta*
// of T* and K of volume_split()
//
//   w = int (T* - T) : D^-1 (T* - T), of the pointwise theta, - K (theta - mean theta)^2 dV
//
// where linear tets have nothing to average, and quadratic ones, which take the change of volume theta of their energy
// on average, may be too soft rather than too stiff. D is that of the law at rest. By Galerkin's orthogonality w is
// what the load's work is short of: it stands for the relative error of the displacements, each weighted by its load.
//
// The estimate of a moving body is that of the shape that its current forces would hold: it has nothing of the error in
// the frequencies that has added up.
#pragma once
#include <stop_token>
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

struct MeshError {
  /// Root of int |u* - u|^2 dV / int |u*|^2 dV, u* being that of the finer solution; |w| / int T* : D^-1 T* without
  /// one. Pieces that nothing holds count without their rigid motion.
  double displacement = 0;
  /// Of the recovered von Mises stress that 99 % of the volume stay below (sim/accuracy/nodal_stress.h), relative to
  /// that of T*; without a finer solution, that of the tets.
  double peak_stress = 0;
  double peak = 0;          // that of T* [Pa]
  double peak_of_tets = 0;  // that of the tets themselves [Pa]
  /// [tet_count] of the squares: root of their mean in the tet over that of T* : D^-1 T* in the body.
  std::vector<float> tets{};
};

/// Zeros at rest, and once `stop` is requested.
MeshError estimate_mesh_error(const Model& model, const State& state, const std::stop_token& stop = {});

/// [vertex_count] the means of MeshError::tets around each vertex, weighted by volume.
std::vector<float> at_vertices(const Model& model, const MeshError& error);

}  // namespace fascia
