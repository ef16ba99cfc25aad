// A bar with everything that a tangent may depend on: held at one end, stretched at the other, bent by its weight and
// pulled by a spring.
#pragma once
#include "tests/sim/reference/box_model.h"

namespace fascia::test {

struct BarParameters {
  double young = 2e4, poisson = 0.4, density = 1000, damping = 0.01, gravity = 9.81, stretch = 0.02, stiffness = 5;
};

inline Model bar_model(const BarParameters& p, MaterialModel law) {
  Material material = soft(p.young, p.poisson, p.damping);
  material.density = p.density;
  material.model = law;
  Model model = box_model(8, 2, 2, {0.2, 0.04, 0.04}, material, [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
  model.gravity = {0, -p.gravity, 0};
  Motion motion;
  motion.vertices = vertices_where(model, [](const Eigen::Vector3d& x) { return x.x() > 0.2 - 1e-9; });
  motion.translate = {p.stretch, 0, 0};
  motion.duration = 1;
  model.motions = {motion};
  return model;
}

inline std::vector<GrabSpring> bar_springs(double stiffness) {
  return {{40, Eigen::Vector3d(0, 0.01, 0.02), stiffness}};
}

/// [parameter] with its value moved by a share of it.
inline BarParameters moved(BarParameters parameters, double BarParameters::*field, double share) {
  parameters.*field *= 1 + share;
  return parameters;
}

/// d f/d p of fourth order, from f(share) at p (1 + share).
template <class F>
Eigen::VectorXd difference_quotient(const F& f, double value, double share) {
  return (8 * (f(share) - f(-share)) - (f(2 * share) - f(-2 * share))) / (12 * share * value);
}

}  // namespace fascia::test
