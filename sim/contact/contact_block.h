// A part of the Hessian of contact, and what friction does within a step: for tools and tissue alike.
#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace fascia {

/// The penalty on sliding, as a factor of that on depth, on tissue, on planes and on tools that stand still. Friction
/// lasts from step to step with any: a stiff one makes the bound of friction a sharp kink, at which iterations take
/// back one step after another.
inline constexpr double kStickingPenalty = 1.0 / 30;
/// The same under other tools while they move. Points come and go there, and must bear their friction soon.
inline constexpr double kPassingPenalty = 1.0 / 10;

struct ContactBlock {
  std::uint32_t row_vertex, column_vertex;
  Eigen::Matrix3d hessian;  // [N/m]
  double reach;             // [m] largest coordinate that the force is computed from
};

/// q, or as much of it as friction bears [N].
Eigen::Vector3d within(const Eigen::Vector3d& q, double bound);
/// The friction [N] that the next step starts with, of q at the end of a step with the bound `before`, if the bound is
/// `now` at its end. A point that slid, |q| > `before`, bears all of `now`. One that has just touched, `before` = 0,
/// slid without friction: it bears k times its way, within `now`, so that it need not slide on to bear its friction.
/// `sticking`: the penalty on sliding over that on depth.
Eigen::Vector3d kept_friction(const Eigen::Vector3d& q, double before, double now, double sticking);
/// Energy [J] of q within the bound b, with the penalty c [N/m]: |q| <= b: |q|^2 / (2 c), else (b |q| - b^2 / 2) / c.
double sticking_energy(const Eigen::Vector3d& q, double bound, double penalty);
/// Its second derivatives by the way across the normal `n` [N/m].
Eigen::Matrix3d sticking_hessian(const Eigen::Vector3d& q, double bound, double penalty, const Eigen::Vector3d& n);

}  // namespace fascia
