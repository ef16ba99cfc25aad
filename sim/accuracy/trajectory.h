// A run as its displacements at some moments, and how far it is from a better one.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia {

/// Displacements at the same moments whatever the steps, the last one the end: [moment][vertex] [m].
struct Trajectory {
  std::vector<std::vector<Eigen::Vector3d>> displacement;
  double peak_stress = 0;  // PeakStress::p99 at the end [Pa]
};

/// Relative errors.
struct RunError {
  double relative = 0;     // at the end: RMS error over RMS displacement, both over all vertices
  double over_run = 0;     // RMS error over RMS displacement, both over all moments and vertices
  double peak_stress = 0;  // of PeakStress::p99, at the end
  bool complete = true;    // false: not known, such as after a repetition that was stopped
};

/// Both at the same moments, at the same vertices.
RunError error_of(const Trajectory& found, const Trajectory& truth);

}  // namespace fascia
