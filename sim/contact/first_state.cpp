#include "sim/contact/first_state.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "sim/contact/contact_block.h"
#include "sim/contact/contact_surface.h"
#include "sim/contact/row_stiffness.h"
#include "sim/model/model.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/tool/shape_distance.h"
#include "sim/tool/tool_motion.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using RigidMotion = Eigen::Matrix<double, 6, 1>;  // of a rigid body: translation [m], turn times its size [m]

constexpr double kTouchingGap = 1e-3;  // mean edges
constexpr double kLeaving = 1e-6;      // of the speed of a point: away from what it touches

struct Support {
  std::size_t row;
  RigidMotion lift;      // way along the tool's normal by a motion
  double depth = 0;      // [m] in the tool; 0 where the point only touches it
  double stiffness = 0;  // [N/m]
};

struct LyingBody {
  double mass = 0, size = 0;  // [kg], [m]
  Vector3d center{0, 0, 0};   // of mass
  std::vector<Support> supports;
  bool deep = false;
};

// Minimizes the energy of the springs, which push and do not pull, and of a force, by Newton's method: it is convex,
// and its second derivatives change where springs begin to push. A weak spring stands for whatever nothing carries.
std::vector<double> carrying(const LyingBody& body, const Vector3d& load) {
  constexpr int kMostIterations = 100;
  constexpr double kWeak = 1e-6;  // of all the others together
  double stiffness = 0, pressed = 0;
  for (const Support& support : body.supports) {
    stiffness += support.stiffness;
    pressed += support.stiffness * support.depth;
  }
  RigidMotion weight = RigidMotion::Zero(), motion = RigidMotion::Zero();
  weight.head<3>() = load;
  const auto energy_of = [&](const RigidMotion& q) {
    double energy = 0.5 * kWeak * stiffness * q.squaredNorm() - weight.dot(q);
    for (const Support& s : body.supports)
      energy += 0.5 * s.stiffness * std::pow(std::min(0.0, s.lift.dot(q) - s.depth), 2);
    return energy;
  };
  for (int i = 0; i < kMostIterations; ++i) {
    Eigen::Matrix<double, 6, 6> hessian = kWeak * stiffness * Eigen::Matrix<double, 6, 6>::Identity();
    RigidMotion force = weight - kWeak * stiffness * motion;
    for (const Support& s : body.supports) {
      const double way = s.lift.dot(motion) - s.depth;
      if (way > 0) continue;
      hessian += s.stiffness * s.lift * s.lift.transpose();
      force -= s.stiffness * way * s.lift;
    }
    if (force.norm() <= 1e-12 * (weight.norm() + pressed)) break;
    const RigidMotion step = hessian.ldlt().solve(force);
    const double before = energy_of(motion), slope = force.dot(step);
    double share = 1;
    while (share > 1e-6 && energy_of(motion + share * step) > before - 1e-4 * share * slope) share /= 2;
    motion += share * step;
  }
  std::vector<double> forces;
  for (const Support& s : body.supports) forces.push_back(s.stiffness * std::max(0.0, s.depth - s.lift.dot(motion)));
  return forces;
}

}  // namespace

State first_state(const Model& model) {
  State state = initial_state(model);
  const ContactSurface surface = make_contact_surface(model);
  const UnconstrainedParts free = unconstrained_parts(model, model.held());
  if (surface.empty() || free.parts == 0) return state;

  std::vector<LyingBody> bodies(free.parts + 1);  // the first for what is held
  const std::vector<double> masses = consistent_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v) {
    bodies[free.part[v]].mass += masses[v];
    bodies[free.part[v]].center += masses[v] * model.rest_positions[v];
  }
  for (LyingBody& body : bodies) body.center /= body.mass;
  for (std::size_t v = 0; v < masses.size(); ++v) {
    LyingBody& body = bodies[free.part[v]];
    body.size = std::max(body.size, (model.rest_positions[v] - body.center).norm());
  }

  ContactMemory touches(surface.row_count);  // with equal forces
  const ToolMotion motion = motion_on_paths(model.tools, 0, 0);
  const double mean_edge = surface.full_slip / kFullSlip, touching = kTouchingGap * mean_edge;
  for (const ContactPiece& piece : surface.pieces) {
    const Tool& tool = model.tools[piece.tool];
    const RigidPose pose = tool.pose_of_piece(piece.piece, motion.from[piece.tool]);
    for (std::uint32_t p = 0; p < piece.points; ++p) {
      const ContactPoint& point = surface.points[p];
      const std::uint32_t part = free.part[point.vertices[0]];
      if (part == 0) continue;
      const Vector3d x = point.at(model.rest_positions), velocity = point.at(state.velocity);
      if (!has_row(surface, piece, p, tool.shape, x, pose, pose, 0)) continue;
      const ShapeDistance distance = distance_to(tool.shape, pose.to_local(x));
      const double gap = distance.distance - 0.5 * model.contact.thickness;
      LyingBody& body = bodies[part];
      body.deep |= gap < -touching;
      const Vector3d normal = pose.axes * distance.normal.normalized();
      if (gap > touching || velocity.dot(normal) > kLeaving * velocity.norm()) continue;
      RigidMotion lift;
      lift << normal, (x - body.center).cross(normal) / body.size;
      body.supports.push_back({piece.first_row + p, lift, gap < -touching ? -gap : 0});
      touches[piece.first_row + p].normal = 1;
    }
  }

  const std::vector<double> stiffness = row_stiffness(model, surface, contact_stiffness(model, surface), touches,
                                                      motion, state.displacement, state.displacement);
  for (LyingBody& body : bodies) {
    if (body.supports.empty() || (!body.deep && model.gravity.isZero())) continue;
    // Penalties are those of cells, times a factor. The body that tools squeeze is softer, as it is longer than a cell.
    const double softer = body.deep ? mean_edge / (body.size * kContactPenalty * model.contact.stiffness) : 1;
    for (Support& support : body.supports) support.stiffness = softer * stiffness[support.row];
    const std::vector<double> forces = carrying(body, (body.deep ? 0 : body.mass) * model.gravity);
    state.contact.resize(surface.row_count);
    for (std::size_t i = 0; i < forces.size(); ++i) state.contact[body.supports[i].row].normal = forces[i];
  }
  return state;
}

}  // namespace fascia
