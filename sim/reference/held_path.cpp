#include "sim/reference/held_path.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia::reference {
namespace {

using Eigen::VectorXd;

constexpr double largest_turn = 0.5;  // [rad] a linear prediction stretches a part that rotates by this much to 1.12

}  // namespace

HeldPath::HeldPath(const Model& model, const VectorXd& displacement, double from, double to)
    : model_(model), from_(from), to_(to), motions_(model.motions) {
  for (Motion& motion : motions_)
    // A jump in this interval; a state at time 0 has made none yet.
    if (motion.duration == 0 && motion.start <= to && (motion.start > from || from == 0)) {
      motion.start = from;
      motion.duration = to - from;
    }
  offset_ = -positions(from_);
  for (const Motion& motion : motions_)
    for (const std::uint32_t v : motion.vertices) offset_.segment<3>(3 * v) += displacement.segment<3>(3 * v);
}

VectorXd HeldPath::positions(double t) const {
  VectorXd u = VectorXd::Zero(3 * model_.rest_positions.size());
  for (const Motion& motion : motions_)
    for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
      const std::uint32_t v = motion.vertices[k];
      u.segment<3>(3 * v) = motion.position(k, model_.rest_positions[v], t) - model_.rest_positions[v];
    }
  return u;
}

void HeldPath::place(double s, VectorXd& u) const {
  const VectorXd held = positions(from_ + s * (to_ - from_)) + (1 - s) * offset_;
  for (const Motion& motion : motions_)
    for (const std::uint32_t v : motion.vertices) u.segment<3>(3 * v) = held.segment<3>(3 * v);
}

bool HeldPath::moves() const { return positions(to_) != positions(from_) + offset_; }

double HeldPath::largest_increment() const {
  double increment = 1;
  for (const Motion& motion : motions_) {
    if (!motion.targets.empty() || motion.angle == 0 || motion.duration == 0) continue;
    const double turn = std::abs(motion.angle) * (to_ - from_) / motion.duration;
    increment = std::min(increment, largest_turn / turn);
  }
  return increment;
}

void require_supports(const Model& model) {
  if (model.gravity.isZero(0)) return;
  const UnconstrainedParts unconstrained = unconstrained_parts(model, model.held());
  if (unconstrained.parts > 0)
    throw Error("static equilibrium",
                "a component of the mesh (" + vertex_name(model, unconstrained.first) + ") is unconstrained",
                "expected fixed or prescribed vertices in every component, or no gravity");
}

}  // namespace fascia::reference
