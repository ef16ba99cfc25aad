// The implicit Euler method: a step of length h from displacements u_n and velocities v_n as a minimization over the
// displacements u at its end.
//
//   minimize 1/(2 h^2) (u - u~)^T M (u - u~) + E(u),    u~ = u_n + h v_n + h^2 g,    v = (u - u_n) / h
//
// First order in time, and damps motion whose period is not much longer than h. Vectors are [3 * vertex_count]. The
// passes of the GPU solver are in sim/gpu/integrators/implicit_euler.h.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct ImplicitEuler {
  double h;  // [s]

  using Vector = Eigen::VectorXd;
  /// u~ [m]. `gravity`: of every vertex [m/s^2].
  Vector predicted(const Vector& u_n, const Vector& v_n, const Vector& gravity) const {
    return u_n + h * v_n + h * h * gravity;
  }
  /// M / h^2 [kg/s^2], which weights the distance to u~.
  Vector inertia(const Vector& mass) const { return mass / (h * h); }
  /// v [m/s] at the end of the step.
  Vector velocity(const Vector& u, const Vector& u_n) const { return (u - u_n) / h; }
};

}  // namespace fascia
