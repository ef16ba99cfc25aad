// Conjugate gradients for estimates: a few digits of the solution are enough.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <stop_token>
#include <utility>
#include <vector>

namespace fascia {

/// Solves `apply`(x) = `residual` from x = 0, until `share` is left of the squared residual in the norm of the
/// preconditioner, or the curvature is negative. False if it was stopped, or not done after 500 steps.
template <class Apply, class Precondition>
bool conjugate_gradients(const std::vector<Eigen::Vector3d>& residual, const Apply& apply,
                         const Precondition& precondition, double share, const std::stop_token& stop,
                         std::vector<Eigen::Vector3d>& x) {
  using Vectors = std::vector<Eigen::Vector3d>;
  const auto dot = [](const Vectors& a, const Vectors& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
  };
  constexpr int kMost = 500;
  x.assign(residual.size(), Eigen::Vector3d::Zero());
  Vectors left = residual, z = precondition(left), way = z;
  double size = dot(left, z);
  const double enough = share * size;
  for (int i = 0; i < kMost && size > enough; ++i) {
    if (stop.stop_requested()) return false;
    const Vectors force = apply(way);
    const double curvature = dot(way, force);
    if (!(curvature > 0)) return i > 0;
    const double length = size / curvature;
    for (std::size_t k = 0; k < way.size(); ++k) {
      x[k] += length * way[k];
      left[k] -= length * force[k];
    }
    z = precondition(left);
    const double before = std::exchange(size, dot(left, z));
    for (std::size_t k = 0; k < way.size(); ++k) way[k] = z[k] + size / before * way[k];
  }
  return size <= enough;
}

}  // namespace fascia
