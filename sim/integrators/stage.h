// A stage of a time integrator: the form that all integrators here share, an implicit Euler step of length l from
// extrapolated values. With X* = X + p (X - X_earlier), where X stands for displacements, velocities and Green strains
// at the start of the stage, and X_earlier for those at the start of the stage or substep before,
//
//   minimize 1/(2 l^2) (u - u~)^T M (u - u~) + E(u),    u~ = u* + l v* + l^2 g,    v = (u - u*) / l
//
// is the whole stage, and viscosity resists (eps - eps*) / l. Solvers therefore see nothing of an integrator but l and
// u~. Vectors are [3 * vertex_count]. The passes of the GPU solver are in sim/gpu/integrators/stage.h.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct IntegratorStage {
  double length;             // l [s]
  double extrapolation = 0;  // p [-]; 0: nothing earlier is read
  double duration = length;  // by which time advances [s]
  double share = 1;          // of its forces in what changes the momentum in a substep; those of all stages sum to 1

  using Vector = Eigen::VectorXd;
  /// X*. `earlier` is not read without extrapolation.
  template <class X>
  X extrapolated(const X& now, const X& earlier) const {
    if (extrapolation == 0) return now;
    return now + extrapolation * (now - earlier);
  }
  /// u~ [m] from u* and v*. `gravity`: of every vertex [m/s^2].
  Vector predicted(const Vector& u, const Vector& v, const Vector& gravity) const {
    return u + length * v + length * length * gravity;
  }
  /// M / l^2 [kg/s^2], which weights the distance to u~; `mass`: the diagonal of M, or M times a distance.
  Vector inertia(const Vector& mass) const { return mass / (length * length); }
  /// v [m/s] at the end of the stage, from u there and u*.
  Vector velocity(const Vector& u, const Vector& start) const { return (u - start) / length; }
  /// dv/dt [m/s^2] in the stage, from v at its end and v*.
  Vector acceleration(const Vector& v, const Vector& start) const { return (v - start) / length; }

  bool operator==(const IntegratorStage&) const = default;
};

}  // namespace fascia
