#include "sim/tool/tool.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/rotation.h"
#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void add_jaws(const JawsShape& jaws, Tool& tool) {
  tool.shape = jaws.shape;
  tool.has_jaws = true;
  tool.hinge = jaws.axis.normalized();
  const Vector3d middle = middle_of(jaws.shape), reach = middle - middle.dot(tool.hinge) * tool.hinge;
  // The tool's axis nearest to the middle of the jaw, of those across the hinge.
  Vector3d forward = tool.hinge.unitOrthogonal();
  double nearest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector3d across = Vector3d::Unit(k) - tool.hinge[k] * tool.hinge;
    if (across.norm() < 0.5) continue;
    const double along = reach.dot(across.normalized());
    if (std::abs(along) > nearest) {
      nearest = std::abs(along);
      forward = across.normalized() * (along < 0 ? -1 : 1);
    }
  }
  const Vector3d normal = tool.hinge.cross(forward);
  tool.mirror.axes = Matrix3d::Identity() - 2 * normal * normal.transpose();
  tool.open = 0.5 * jaws.open_deg * std::numbers::pi / 180 * (reach.dot(normal) < 0 ? -1 : 1);
}

Tool standing(const std::string& name, const ToolShape& shape, const std::optional<double>& friction,
              const ContactSettings& contact) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.friction = friction.value_or(contact.friction);
  tool.path.emplace_back();
  return tool;
}

}  // namespace

ToolPlace Tool::place(double t) const {
  if (path.empty()) return {};
  Instrument::Key key = t < path.front().time ? path.front() : path.back();
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Instrument::Key &a = path[k - 1], &b = path[k];
    if (t < a.time || t >= b.time) continue;
    const double s = (t - a.time) / (b.time - a.time), share = smooth ? s * s * (3 - 2 * s) : s;
    key.position = (1 - share) * a.position + share * b.position;
    key.rotate_deg = (1 - share) * a.rotate_deg + share * b.rotate_deg;
    key.grip = (1 - share) * a.grip + share * b.grip;
  }
  return {{rotation_of(key.rotate_deg), key.position}, key.grip};
}

RigidPose Tool::pose_of_piece(std::size_t piece, const ToolPlace& place) const {
  if (!has_jaws) return place.pose;
  const double angle = open * (1 - place.grip);
  const auto turned = [&](double by) { return RigidPose{Eigen::AngleAxisd(by, hinge).toRotationMatrix(), {0, 0, 0}}; };
  const RigidPose local = piece == 0 ? turned(angle) : composed(turned(-angle), mirror);
  return composed(place.pose, local);
}

std::vector<Tool> tools_of(const SceneTools& tools) {
  std::vector<Tool> result;
  if (tools.ground)
    result.push_back(
        standing("ground", PlaneShape{{0, tools.ground->height, 0}, {0, 1, 0}}, tools.ground->friction, tools.contact));
  for (const Obstacle& obstacle : tools.obstacles) {
    Tool& tool = result.emplace_back(standing(obstacle.name, obstacle.shape, obstacle.friction, tools.contact));
    tool.path.front() = {0, obstacle.position, obstacle.rotate_deg};
  }
  for (const Instrument& instrument : tools.instruments) {
    Tool& tool = result.emplace_back(standing(instrument.name, {}, instrument.friction, tools.contact));
    if (const auto* jaws = std::get_if<JawsShape>(&instrument.shape))
      add_jaws(*jaws, tool);
    else
      tool.shape = std::get<ToolShape>(instrument.shape);
    tool.path = instrument.path;
    tool.smooth = instrument.smooth;
  }
  return result;
}

std::vector<ToolPlace> places_at(const std::vector<Tool>& tools, double t) {
  std::vector<ToolPlace> places;
  for (const Tool& tool : tools) places.push_back(tool.place(t));
  return places;
}

}  // namespace fascia
