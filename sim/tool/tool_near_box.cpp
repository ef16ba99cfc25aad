#include "sim/tool/tool_near_box.h"

#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::AlignedBox3d;

constexpr int kHalvings = 6;  // of the box: twice along each axis of a cube

// By balls around ever smaller parts of the box.
bool is_near(const ToolShape& shape, const RigidPose& pose, const AlignedBox3d& part, double reach, int halvings) {
  const double distance = distance_to(shape, pose.to_local(part.center())).distance;
  if (distance - 0.5 * part.diagonal().norm() > reach) return false;
  if (halvings == 0 || !(distance > reach)) return true;
  Eigen::Index longest = 0;
  part.sizes().maxCoeff(&longest);
  AlignedBox3d lower = part, upper = part;
  lower.max()[longest] = upper.min()[longest] = part.center()[longest];
  return is_near(shape, pose, lower, reach, halvings - 1) || is_near(shape, pose, upper, reach, halvings - 1);
}

}  // namespace

bool is_near_box(const Tool& tool, const ToolPlace& place, const AlignedBox3d& box, double reach) {
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece)
    if (is_near(tool.shape, tool.pose_of_piece(piece, place), box, reach, kHalvings)) return true;
  return false;
}

}  // namespace fascia
