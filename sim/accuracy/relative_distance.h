// The measure of all errors against another solution of the same mesh.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace fascia {

/// RMS distance of displacements to the true ones, over the RMS of these; 0 where both are zero.
inline double relative_distance(const std::vector<Eigen::Vector3d>& found, const std::vector<Eigen::Vector3d>& truth) {
  double squared = 0, whole = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    squared += (found[v] - truth[v]).squaredNorm();
    whole += truth[v].squaredNorm();
  }
  return squared == 0 ? 0 : std::sqrt(squared / whole);
}

}  // namespace fascia
