// A part of the Hessian of contact, and what friction does within a step: for tools and tissue alike.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace fascia {

/// The least penalty on sliding, as a factor of that on depth, and that between tissue and tissue. Anchors hold with
/// any: a stiff one makes the bound of friction a sharp kink, at which iterations take back one step after another.
inline constexpr double kStickingPenalty = 1.0 / 30;
/// The slip on a tool after which a point bears all of its friction, in mean edges of the surface. One whose load is
/// large for its area would else slide on for more than a cell before it does.
inline constexpr double kFullSlip = 0.1;
/// The penalty on sliding c [N/m] of a point on a tool: of the penalty on depth `stiffness` [N/m], the bound of
/// friction `bound` [N] and the slip `full_slip` [m].
double sliding_penalty(double stiffness, double bound, double full_slip);
/// The penalty on depth [N/m] in a stage of `length` [s], of one `stiffness` [N/m] for long stages and the `mass` [kg]
/// at the point: what presses must be out of the tool a stage later. A stage that is short beside the oscillation of
/// the two would follow it, and the multiplier, which grows while the point is still inside, add energy to it.
/// `damping` [N s/m] of what the mass is on ties more of it to the point.
double stage_stiffness(double stiffness, double mass, double damping, double length);

/// The normal force that the next stage starts with [N]: the mean of what the `pressing` of this stage was, by its
/// `share` of the forces in the substep, and of what it started with. Friction of each stage goes by what another one
/// left: by that alone its impulse would be off where the forces of stages differ, or a stage presses with none. So the
/// sum of what friction went by in the substeps, and of what is kept, is that of what pressed. Less than the penalty on
/// depth, `stiffness` [N/m], has after a way that rounding hides is none.
inline double kept_force(double pressing, double before, double share, double stiffness) {
  constexpr double kHidden = 1e-12;  // [m]
  const double kept = share * pressing + (1 - share) * before;
  return kept > kHidden * stiffness ? kept : 0;
}

struct ContactBlock {
  std::uint32_t row_vertex, column_vertex;
  Eigen::Matrix3d hessian;  // [N/m]
  double reach;             // [m] largest coordinate that the force is computed from
};

/// q, or as much of it as friction bears [N].
Eigen::Vector3d within(const Eigen::Vector3d& q, double bound);
/// Energy [J] of q within the bound b, with the penalty c [N/m]: |q| <= b: |q|^2 / (2 c), else (b |q| - b^2 / 2) / c.
double sticking_energy(const Eigen::Vector3d& q, double bound, double penalty);
/// Its second derivatives by the way across the normal `n` [N/m].
Eigen::Matrix3d sticking_hessian(const Eigen::Vector3d& q, double bound, double penalty, const Eigen::Vector3d& n);

/// Of a row at some displacements.
struct RowState {
  double depth;                // [m] of the penalty
  Eigen::Vector3d tangential;  // q [N]
};

/// What presses or may press, as motions of whole bodies see it.
struct BodyContact {
  static constexpr std::uint32_t kTool = ~0u;
  std::array<std::uint32_t, 2> bodies;      // that the normal points to, and the other or kTool
  std::array<Eigen::Vector3d, 2> places;    // of what touches on both sides [m]; on a tool of no matter
  Eigen::Vector3d normal;                   // a unit vector
  double stiffness, before, depth;          // k [N/m], lambda [N], of the penalty on depth [m]
  Eigen::Vector3d slip_normal, tangential;  // n0, q [N]
  double sliding, bound;                    // c [N/m], b [N]
};

}  // namespace fascia
