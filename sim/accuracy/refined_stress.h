// What quadratic tets lack, from the same body with each tet cut in eight, quadratic again: the loads that hold the
// tets move it on to its own equilibrium, with the averages of the change of volume (volume_split()) and the
// masses of the finer tets. Cubic functions on the same tets are no substitute: at the edges of supports they are
// hardly better than quadratic ones, and without the averages they are stiffer where these are too soft.
//
// Loads: sim/accuracy/spread_loads.h; what forces at vertices have beside them stays there. Newton's method, whose
// linear problems are solved by conjugate gradients without a matrix, as far as it pays and the curvature is positive
// (Dembo, Steihaug 1983), with halved steps where the energy would rise. The preconditioner (Bramble, Pasciak, Xu 1990)
// adds the factorized linear tets of the coarse mesh, and the blocks of the linear and of the quadratic functions of
// the finer one.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "sim/accuracy/refined_model.h"
#include "sim/elements/quadratic_tet.h"
#include "sim/material/law.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/reference/elasticity.h"

namespace fascia {

class RefinedStress {
 public:
  static constexpr std::size_t kMostTets = 10'000;  // 30 kB and half a millisecond each

  /// Of the quadratic tets of a model, which must not change. Ends early once `stop` is requested.
  RefinedStress(const Model& model, const State& state, const std::stop_token& stop = {});

  /// Whether the search ended: not if it was stopped, or tets are too flat for the factorization or the iterations.
  bool converged() const { return converged_; }

  /// The integration points of the eight tets.
  struct Point {
    Eigen::Vector4d barycentric;  // in the whole tet
    reference::Vector6d stress;   // T* [Pa] as in sim/accuracy/recovered_stress.h
    double growth_gap;            // PointStress::growth_gap of the finer tet
  };
  static constexpr std::size_t kPoints = 8 * QuadraticTet::kPoints;
  /// Of one tet; all have the same weight, since the eight have the same volume.
  std::array<Point, kPoints> at(std::size_t tet) const;

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
  void update_points();
  void move_on(const Vectors& loads, const std::stop_token& stop);
  Vectors loads_of(const Vectors& coarse_forces) const;
  Vectors residual(const Vectors& loads) const;
  Vectors apply(const Vectors& to) const;
  QuadraticTet::PointGradients added_stresses(const Element& element, const Vectors& of) const;
  bool solve(const Vectors& residual, const std::stop_token& stop, Vectors& delta) const;

  const Model& model_;
  RefinedModel refined_;
  std::vector<Element> elements_;
  bool converged_ = false;
};

}  // namespace fascia
