// A stage alone, which without extrapolation is implicit Euler, in closed form, on one vertex.
#include <catch2/catch.hpp>

#include "sim/integrators/stage.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("implicit Euler falls n (n + 1) / 2 h^2 g in n steps") {
  const IntegratorStage euler{0.01};
  const Eigen::VectorXd gravity = Vector3d(0, -9.81, 0.5);
  Eigen::VectorXd u = Vector3d(0.1, 0.2, 0.3), v = Vector3d(1, 0, -2);
  const Eigen::VectorXd start = u, speed = v;
  const int steps = 7;
  for (int n = 0; n < steps; ++n) {
    const Eigen::VectorXd next = euler.predicted(u, v, gravity);
    v = euler.velocity(next, u);
    u = next;
  }
  const Eigen::VectorXd expected =
      start + steps * euler.length * speed + 0.5 * steps * (steps + 1) * euler.length * euler.length * gravity;
  CAPTURE(u.transpose(), expected.transpose());
  CHECK((u - expected).norm() < 1e-14);
  CHECK((v - (speed + steps * euler.length * gravity)).norm() < 1e-12);
}

TEST_CASE("a step of implicit Euler minimizes its objective for a spring: 1 / (1 + h^2 k / m) of the prediction") {
  const IntegratorStage euler{0.1};
  const Eigen::VectorXd mass = Eigen::VectorXd::Constant(3, 2.0), zero = Eigen::VectorXd::Zero(3);
  const Eigen::VectorXd u_n = Vector3d(0.3, 0, 0), v_n = Vector3d(-1, 0, 0);
  constexpr double kStiffness = 50;
  const Eigen::VectorXd target = euler.predicted(u_n, v_n, zero), inertia = euler.inertia(mass);
  // inertia (u - target) + k u = 0
  const double u = inertia[0] * target[0] / (inertia[0] + kStiffness);
  CAPTURE(u, inertia[0]);
  CHECK(u == Approx(target[0] / (1 + euler.length * euler.length * kStiffness / mass[0])).epsilon(1e-14));
}
