// Where a body goes if its tets get more freedom under the same loads: linear tets become quadratic, with edges that
// bend, and quadratic ones are cut in eight, quadratic again, with the averages of the change of volume
// (volume_split()) and the masses of the finer tets (sim/accuracy/refined_model.h). Cubic functions on quadratic tets
// are no substitute: at the edges of supports they are hardly better, and without the averages they are stiffer where
// quadratic ones are too soft.
//
// Loads: sim/accuracy/spread_loads.h; what forces at vertices have beside them stays there. Newton's method, whose
// linear problems are solved by conjugate gradients without a matrix, as far as it pays and the curvature is positive
// (Dembo, Steihaug 1983), with halved steps where the energy would rise. The preconditioner (Bramble, Pasciak, Xu 1990)
// adds the factorized linear tets of the coarse mesh, and the blocks of the linear and of the quadratic functions of
// the finer one. Pieces that nothing holds keep place and direction: their loads stay where they point, and what lies
// on such loads would fall over.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "sim/accuracy/refined_model.h"
#include "sim/accuracy/rigid_motions.h"
#include "sim/elements/quadratic_tet.h"
#include "sim/material/law.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/reference/elasticity.h"

namespace fascia {

class FinerSolution {
 public:
  /// 4 kB for each finer tet.
  static constexpr std::size_t most_tets(ElementOrder kind) {
    return kind == ElementOrder::quadratic ? 10'000 : 50'000;
  }

  /// Of the tets of one kind of a model, which must not change. Ends early once `stop` is requested.
  FinerSolution(const Model& model, const State& state, ElementOrder kind, const std::stop_token& stop = {});

  /// Whether the search ended: not if it was stopped, or tets are too flat for the factorization or the iterations.
  bool converged() const { return converged_; }

  /// [vertex_count of the model] displacements [m]; those of tets of the other kind are the state's.
  std::vector<Eigen::Vector3d> displacements() const;

  /// The integration points of the finer tets.
  struct Point {
    Eigen::Vector4d barycentric;  // in the coarse tet
    reference::Vector6d stress;   // T* [Pa] as in sim/accuracy/recovered_stress.h
    double growth_gap;            // PointStress::growth_gap of the finer tet
  };
  /// Of one tet; all have the same weight, since the finer tets in one have the same volume.
  std::vector<Point> at(std::size_t tet) const;

 private:
  using Vectors = std::vector<Eigen::Vector3d>;  // [vertex] of the finer mesh
  struct PointState {
    Eigen::Matrix3d f, first_piola, dilatation;  // F, P, dtheta/dF
    Matrix9d tangent;                            // dP/dF without the change of the average
  };
  struct Element {
    QuadraticTet rest;
    std::array<std::uint32_t, 10> vertices;
    double mu, lambda, bulk;  // [Pa]
    double energy;            // [J]
    std::array<PointState, QuadraticTet::kPoints> points;
  };

  void make_elements();
  void keep_free_pieces();
  void update_points();
  void move_on(const Vectors& loads, const std::stop_token& stop);
  Vectors forces_of_coarse_tets(const State& state) const;
  Vectors loads_on_cut_tets(const Vectors& coarse_forces) const;
  Vectors loads_on_edges(const Vectors& coarse_forces) const;
  Vectors residual(const Vectors& loads) const;
  Vectors apply(const Vectors& to) const;
  QuadraticTet::PointGradients added_stresses(const Element& element, const Vectors& of) const;
  bool solve(const Vectors& residual, const std::stop_token& stop, Vectors& delta) const;

  const Model& model_;
  const ElementOrder kind_;
  RefinedModel refined_;
  std::vector<Element> elements_;
  RigidMotions free_;  // of the pieces that nothing holds
  bool converged_ = false;
};

}  // namespace fascia
