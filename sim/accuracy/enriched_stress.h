// What the stress of linear tets lacks, from the same mesh with edges that bend: tets gain the functions
// 4 L_a L_b of their edges, and so become quadratic, and the body moves on by the delta of
//
//   a(delta, v) = l(v) - sum_t P_t : int grad v dV    for all quadratic v,
//   a(u, v) = sum_t int 2 mu eps(u) : eps(v) dV + lambda / V int tr eps(u) dV int tr eps(v) dV
//
// in the axes that each tet has now (a hierarchical estimate: Bank, Smith 1993). The change of volume counts on
// average, since it would lock tets otherwise. l are the loads that hold the linear tets in their shape
// (sim/accuracy/spread_loads.h). Held vertices stay, and so do edges between two of them.
// Solved by conjugate gradients without a matrix, preconditioned by the factorized linear tets and the blocks of edges.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "sim/elements/linear_tet.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/reference/elasticity.h"

namespace fascia {

class EnrichedStress {
 public:
  static constexpr std::size_t kMostTets = 50'000;  // factorized in some seconds

  /// Of the linear tets of a model, which must not change. Ends early once `stop` is requested.
  EnrichedStress(const Model& model, const State& state, const std::stop_token& stop = {});

  /// Whether the search ended: not if it was stopped, or tets are too flat for the factorization or the iterations.
  bool converged() const { return converged_; }

  /// What a linear tet's T (sim/accuracy/recovered_stress.h) lacks at barycentric coordinates [Pa]: xx, yy, zz, yz, xz,
  /// xy.
  reference::Vector6d at(std::size_t tet, const Eigen::Vector4d& barycentric) const;

 private:
  struct Element {
    std::uint32_t tet;  // of the model
    LinearTet rest;
    Eigen::Matrix3d rotation;              // R
    Eigen::Matrix<double, 3, 4> forces;    // V P b_a [N]
    std::array<std::uint32_t, 6> edges{};  // in the order of kMidEdgeCorners
  };
  using Vectors = std::vector<Eigen::Vector3d>;  // [vertex], then [edge]

  void make_elements(const State& state);
  void find_edges();
  Vectors loads_of_edges() const;
  Eigen::Matrix3d gradient_at(const Element& element, const Vectors& of, const Eigen::Vector4d& barycentric) const;
  Eigen::Matrix3d mean_gradient(const Element& element, const Vectors& of) const;
  Eigen::Matrix3d stress_at(const Element& element, const Vectors& of, const Eigen::Vector4d& barycentric,
                            double mean_trace) const;
  Vectors apply(const Vectors& to) const;
  void solve(const Vectors& residual, const std::stop_token& stop);

  const Model& model_;
  std::vector<char> held_;                          // [vertex], then [edge]
  std::vector<Element> elements_;                   // of linear tets
  std::vector<std::uint32_t> element_of_;           // [tet]
  std::vector<std::array<std::uint32_t, 2>> ends_;  // [edge]
  Vectors delta_;
  bool converged_ = false;
};

}  // namespace fascia
