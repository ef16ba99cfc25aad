#include "sim/material/invariants.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace fascia {

using Eigen::Matrix3d;

Matrix3d cofactor(const Matrix3d& f) {
  Matrix3d c;
  c << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
  return c;
}

Matrix3d tensor_cross(const Matrix3d& a, const Matrix3d& b) {
  Matrix3d c;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    c.col(k) = a.col(i).cross(b.col(j)) + b.col(i).cross(a.col(j));
  }
  return c;
}

FromRest from_rest(const Matrix3d& f) {
  FromRest r;
  r.h = f - Matrix3d::Identity();
  const Matrix3d of_h = cofactor(r.h);
  const double trace = r.h.trace();
  r.cofactor = trace * Matrix3d::Identity() - r.h.transpose() + of_h;
  r.stretch = 2 * trace + r.h.squaredNorm();
  r.higher = of_h.trace() + r.h.determinant();
  r.volume = trace + r.higher;
  return r;
}

OfVolume above_extended_log(double volume, double least) {
  const double j = 1 + volume;
  if (j >= least) return {volume - std::log1p(volume), volume / j, 1 / (j * j)};
  const double y = (j - least) / least;
  return {volume - (std::log(least) + y - 0.5 * y * y), 1 - (1 - y) / least, 1 / (least * least)};
}

OfVolume volume_term(double j, double k) {
  if (k >= 0 || j <= 1) return {0.5 * k * (j - 1) * (j - 1), k * (j - 1), k};
  const double logarithm = std::log(j);
  return {0.5 * k * logarithm * logarithm, k * logarithm / j, k * (1 - logarithm) / (j * j)};
}

Dilatation volume_change(const Matrix3d& f, bool with_second) {
  Dilatation change{f.determinant() - 1, cofactor(f)};
  if (!with_second) return change;
  for (int k = 0; k < 9; ++k) {
    Matrix3d e = Matrix3d::Zero();
    e(k % 3, k / 3) = 1;
    change.second.col(k) = flat(tensor_cross(f, e));
  }
  return change;
}

}  // namespace fascia
