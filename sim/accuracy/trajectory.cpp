#include "sim/accuracy/trajectory.h"

#include <cmath>

#include "sim/accuracy/relative_distance.h"

namespace fascia {

RunError error_of(const Trajectory& found, const Trajectory& truth) {
  if (truth.displacement.empty()) return {};
  RunError error;
  error.relative = relative_distance(found.displacement.back(), truth.displacement.back());
  std::vector<Eigen::Vector3d> all_found, all_true;
  for (std::size_t moment = 0; moment < truth.displacement.size(); ++moment) {
    all_found.insert(all_found.end(), found.displacement[moment].begin(), found.displacement[moment].end());
    all_true.insert(all_true.end(), truth.displacement[moment].begin(), truth.displacement[moment].end());
  }
  error.over_run = relative_distance(all_found, all_true);
  const double difference = std::abs(found.peak_stress - truth.peak_stress);
  error.peak_stress = truth.peak_stress == 0 ? 0 : difference / truth.peak_stress;  // 0: rounding
  return error;
}

}  // namespace fascia
