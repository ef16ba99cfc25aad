// XPBD with a block constraint per tet in double precision, averaged Jacobi or Gauss-Seidel in the order of the colors,
// plain or accelerated, written from its definition with an explicit 6x12 Jacobian: the reference for the GPU kernels,
// which never form it.
#pragma once
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/ordering/graph_coloring.h"
#include "sim/reference/double_acceleration.h"
#include "sim/reference/elasticity.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia::reference {

class DoubleXpbd {
 public:
  DoubleXpbd(const Model& model, const SolverSettings& settings);
  void step(State& state);

  /// One tet's corrections (per corner) and new multiplier, from positions u, strain at the start of the substep and
  /// multiplier.
  struct TetResult {
    std::array<Eigen::Vector3d, 4> correction;
    Vector6d multiplier;
  };
  TetResult solve_tet(std::size_t tet, const std::vector<Eigen::Vector3d>& u, const Vector6d& previous_strain,
                      const Vector6d& multiplier) const;
  TetResult solve_tet(std::size_t tet, const std::array<Eigen::Vector3d, 4>& corners, const Vector6d& previous_strain,
                      const Vector6d& multiplier) const;
  Vector6d strain(std::size_t tet, const std::vector<Eigen::Vector3d>& u) const;

 private:
  void sweep(std::vector<Eigen::Vector3d>& u, std::vector<Vector6d>& multipliers,
             const std::vector<Vector6d>& previous_strain) const;

  const Model& model_;
  SolverSettings settings_;
  std::vector<double> inv_mass_, seen_inv_mass_;  // of a vertex, and as its tets use it
  std::vector<int> valence_;
  Coloring coloring_;
  DoubleChebyshev chebyshev_;
};

}  // namespace fascia::reference
