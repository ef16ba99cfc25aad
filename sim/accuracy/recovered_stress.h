// The stress that a finer mesh would have, recovered from the stresses of this one: around each corner vertex a
// polynomial is fitted to the points where elements are most accurate, and the polynomials are blended over the tets.
//
//   T*(X) = sum_a L_a(X) p_a(X),   p_a = argmin sum_q V_q |p(X_q) - T_q|^2  over the points q of the tets around a
//
// Fit: superconvergent patch recovery (Zienkiewicz, Zhu 1992), linear for linear tets and quadratic for quadratic ones.
// Blend: conjoint polynomials (Blacker, Belytschko 1994), which need no values at mid-edge vertices. T = R^T P
// is the first Piola-Kirchhoff stress without the rotation of F = R U [Pa]: unlike P it does not turn with the body,
// and unlike F^-1 P it is finite in flat tets. A patch has one material, since stress jumps where materials meet.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/reference/elasticity.h"

namespace fascia {

class RecoveredStress {
 public:
  /// Keeps a reference to the model, which must not change. Incomplete once `stop` is requested.
  RecoveredStress(const Model& model, const State& state, const std::stop_token& stop = {});

  /// T* [Pa] in a tet at barycentric coordinates: xx, yy, zz, yz, xz, xy.
  reference::Vector6d at(std::size_t tet, const Eigen::Vector4d& barycentric) const;

 private:
  struct Patch {
    Eigen::Vector3d center;                     // X [m] of the samples on average
    double scale;                               // 1 / their distance from it [1/m]
    Eigen::Matrix<double, 10, 6> coefficients;  // of terms up to degree 2 in the scaled place
  };
  struct Sample {
    Eigen::Vector3d place;
    double weight;  // [m^3]
    reference::Vector6d stress;
  };
  static Patch fit(const std::vector<Sample>& samples, int most_terms);

  const Model& model_;
  std::vector<Patch> patches_;
  std::vector<std::array<std::uint32_t, 4>> patch_of_;  // [tet_count] of each corner
};

/// A point of a tet with its share of the volume.
struct VolumePoint {
  Eigen::Vector4d barycentric;
  double weight;
};
/// Exact for polynomials of degree 5 (Walkington 2000).
const std::array<VolumePoint, 14>& volume_points();

/// The stress of an element itself at one point.
struct PointStress {
  Eigen::Matrix3d f;           // deformation gradient
  Eigen::Matrix3d rotation;    // R
  reference::Vector6d stress;  // T [Pa]: xx, yy, zz, yz, xz, xy
  double growth_gap = 0;       // theta - its mean over the tet, where the element takes the mean (volume_split())
};
/// Of one tet, at barycentric coordinates.
std::vector<PointStress> stresses_of(const Model& model, const State& state, std::size_t tet,
                                     const std::vector<Eigen::Vector4d>& barycentric);

double volume_of(const Model& model, std::size_t tet);  // at rest [m^3]
Eigen::Matrix3d matrix_of(const reference::Vector6d& components);
reference::Vector6d components_of(const Eigen::Matrix3d& matrix);  // of its symmetric part

}  // namespace fascia
