// The Cauchy stress recovered at vertices, where the tets around disagree, as fields of exports and heat maps:
// of linear tets the least over sigma* of
//
//   int |sum_a L_a sigma*_a - sigma_t|^2 dV
//
// (Oden, Brauchli 1971; Hinton, Campbell 1974), and of quadratic ones, with T* of sim/accuracy/recovered_stress.h,
//
//   sigma(v) = sum_t V_t sym(R_t T*(X_v) F_t^T) / sum_t V_t |J_t|
//
// The fit over the whole body keeps concentrations of stress that means over the tets around a vertex flatten. The
// polynomials of T*, which are nearest to the truth from quadratic tets, overshoot at the surface of linear ones.
// Stress jumps where materials meet, so they are not mixed: a vertex of several has the stress of the one with the
// largest von Mises stress.
#pragma once
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/reference/elasticity.h"

namespace fascia {

struct NodalStress {
  std::vector<reference::Vector6d> cauchy;  // [vertex_count] xx, yy, zz, yz, xz, xy [Pa]; zero without tets
  std::vector<double> von_mises;            // [vertex_count] [Pa]
};

/// Zeros once `stop` is requested.
NodalStress nodal_stress(const Model& model, const State& state, const std::stop_token& stop = {});

/// [vertex_count] shares of the volume of the tets [m^3], as of lumped masses.
std::vector<double> vertex_volumes(const Model& model);

/// The value that 1 % of the volume exceeds; `volumes` is as long as `values`.
double exceeded_by_a_hundredth(const std::vector<double>& values, const std::vector<double>& volumes);

/// Of the von Mises stress at vertices [Pa]. NaN where one of them is not finite.
struct PeakStress {
  double max = 0, p99 = 0;  // p99: exceeded by 1 % of the volume
};
PeakStress peak_of(const NodalStress& stress, const Model& model);

/// Of a displacement, in those of neighbors: half a unit of float32 in the last place each, times what steps add up.
/// Bodies that fly freely have up to a quarter of it. Errors relative to what it deforms would be rounding over
/// rounding.
inline constexpr double kDisplacementRounding = 0x1p-19;
/// The von Mises stress that 1 % of the volume exceeds [Pa] where neighbors move apart by that rounding.
double stress_of_rounding(const Model& model, const State& state);

/// p99 of a state, or 0 where rounding of its displacements (stress_of_rounding()) may be all that it is of.
double peak_beyond_rounding(const Model& model, const State& state, const std::stop_token& stop = {});

/// What the stress p99 is off by, relative to it; TimeError has what the length of steps leaves.
struct PeakErrors {
  std::optional<double> solver;
  double mesh = 0;  // MeshError::peak_stress
};
/// |p99 - p99 of `exact`| over the latter, both beyond rounding; 0 where `exact` has none.
double peak_distance(const Model& model, const State& state, const State& exact, const std::stop_token& stop = {});

}  // namespace fascia
