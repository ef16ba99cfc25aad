#include "app/state/deformed_positions.h"

#include "shaders/shared/types.h"

namespace fascia {

std::vector<Eigen::Vector3d> deformed_positions(Session& session) {
  GpuSolver& solver = *session.simulation.gpu();
  solver.publish();
  const std::vector<shared::vec4> read = solver.positions().read<shared::vec4>();
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(read.size());
  for (const shared::vec4& p : read) positions.emplace_back(p.x, p.y, p.z);
  return positions;
}

}  // namespace fascia
