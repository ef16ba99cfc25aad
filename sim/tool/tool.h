// A tool: the ground, an obstacle or an instrument of a scene, as solvers see it, made of one or two rigid pieces.
#pragma once
#include <string>
#include <vector>

#include "sim/scene/tools/scene_tools.h"
#include "sim/tool/rigid_pose.h"

namespace fascia {

/// Where a tool is: its origin, its axes, and how far its jaws are closed.
struct ToolPlace {
  RigidPose pose;
  double grip = 0;  // 0 open to 1 closed
  bool operator==(const ToolPlace&) const = default;
};

struct Tool {
  std::string name;
  double friction = 0;
  ToolShape shape;  // of every piece
  bool has_jaws = false;
  Eigen::Vector3d hinge{0, 0, 1};     // axis of the jaws in the tool's axes, a unit vector, through its origin
  double open = 0;                    // [rad] by which each jaw turns from closed to open
  RigidPose mirror;                   // of the second jaw when closed
  std::vector<Instrument::Key> path;  // times ascending; without keys it stays at the origin
  bool smooth = false;

  std::size_t piece_count() const { return has_jaws ? 2 : 1; }
  ToolPlace place(double t) const;                                    // on the path at time t [s]
  double end() const { return path.empty() ? 0 : path.back().time; }  // [s] nothing moves after this time
  RigidPose pose_of_piece(std::size_t piece, const ToolPlace& place) const;
};

/// The tools of a scene: the ground, the obstacles and the instruments, each in their order.
std::vector<Tool> tools_of(const SceneTools& tools);
/// [tool] their places at time t [s].
std::vector<ToolPlace> places_at(const std::vector<Tool>& tools, double t);

}  // namespace fascia
