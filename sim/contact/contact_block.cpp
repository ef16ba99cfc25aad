#include "sim/contact/contact_block.h"

#include <algorithm>
#include <cmath>

namespace fascia {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double sliding_penalty(double stiffness, double bound, double full_slip) {
  return std::max(kStickingPenalty * stiffness, bound / full_slip);
}

double stage_stiffness(double stiffness, double mass, double damping, double length) {
  constexpr double kInertia = 9;  // of what is held back: 3 rad of the oscillation
  // Of the mass, and of what a chain of such masses and dampers holds back within the stage [N/m].
  const double own = mass / (length * length), tied = damping / length;
  return std::max(stiffness, kInertia * (0.5 * own + std::sqrt(0.25 * own * own + own * tied)));
}

Vector3d within(const Vector3d& q, double bound) {
  const double length = q.norm();
  return length > bound ? Vector3d(q * (bound / length)) : q;
}

double sticking_energy(const Vector3d& q, double bound, double penalty) {
  const double length = q.norm();
  return (length <= bound ? 0.5 * length * length : bound * length - 0.5 * bound * bound) / penalty;
}

Matrix3d sticking_hessian(const Vector3d& q, double bound, double penalty, const Vector3d& n) {
  const Matrix3d across = Matrix3d::Identity() - n * n.transpose();
  const double length = q.norm();
  if (length <= bound) return penalty * across;
  const Vector3d along = q / length;
  return penalty * (bound / length) * (across - along * along.transpose());
}

}  // namespace fascia
