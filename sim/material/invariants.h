// Functions of a deformation gradient F that laws share: J = det F, its cofactors, and the replacement of log J for
// flat or inverted tets.
#pragma once
#include <Eigen/Core>

namespace fascia {

using Matrix9d = Eigen::Matrix<double, 9, 9>;

Eigen::Matrix3d cofactor(const Eigen::Matrix3d& f);  // dJ/dF

/// The components of a matrix, in column-major order.
inline Eigen::Map<const Eigen::Matrix<double, 9, 1>> flat(const Eigen::Matrix3d& m) {
  return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(m.data());
}

/// The tensor cross product A x B (Bonet, Gil, Ortigosa 2015, eq. 7): bilinear, symmetric, F x F = 2 cof F. The
/// derivative of cof F along A is F x A, the second derivative of J along A and B is F : (A x B).
Eigen::Matrix3d tensor_cross(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Measures of F = I + H without their values at rest, so that small strains lose no digits to terms that cancel there.
struct FromRest {
  Eigen::Matrix3d h, cofactor;  // F - I, cof F - I
  double stretch, volume;       // |F|^2 - 3, J - 1
  double higher;                // J - 1 - tr H
};
FromRest from_rest(const Eigen::Matrix3d& f);

/// A function of J with its first and second derivative.
struct OfVolume {
  double value, first, second;
};

/// J - 1 - l(J) of J - 1, where l is log J, continued below J = `least` by its parabola: finite and ever steeper
/// through J = 0, so that an inverted tet recovers. A smaller ratio keeps tets at the edges of supports upright under
/// larger pressures, but also in tangles: tissue that was pulled through itself returns through J = 0. Hence the
/// law squared has a smaller one, unless it is eased (sim/gpu/readback/tangle_watch.h), and firm the smallest.
inline constexpr double kLeastVolumeRatio = 0.2, kLeastVolumeRatioOfSquared = 0.05, kLeastVolumeRatioOfFirm = 0.003;
OfVolume above_extended_log(double volume, double least = kLeastVolumeRatio);

/// k v(J): v = (J - 1)^2 / 2, and (log J)^2 / 2 where k < 0 and J > 1, since a negative multiple of a parabola has no
/// lower bound.
OfVolume volume_term(double j, double k);

/// A measure of the change of volume that is 0 at rest, and its derivatives by the components of F, in column-major
/// order.
struct Dilatation {
  double value = 0;
  Eigen::Matrix3d first = Eigen::Matrix3d::Zero();
  Matrix9d second = Matrix9d::Zero();  // only where requested
};
Dilatation volume_change(const Eigen::Matrix3d& f, bool with_second);  // J - 1

}  // namespace fascia
