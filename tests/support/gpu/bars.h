// The common bodies and settings of tests of GPU passes and steps.
#pragma once
#include <catch2/catch.hpp>

#include "sim/scene/settings/solver_settings.h"
#include "tests/support/models.h"

namespace fascia::test {

const Material soft{2e4, 0.35, 1050, 0, MaterialModel::st_venant_kirchhoff};

// Fixed at its bottom.
inline Model block() {
  return make_model(make_box(5, 4, 3, {0.1, 0.08, 0.06}), soft, [](const Eigen::Vector3d& x) { return x.y() < 1e-9; });
}

inline Material tissue(double damping = 0) { return {2e4, 0.4, 1000, damping, MaterialModel::st_venant_kirchhoff}; }

inline Model bar(double damping = 0) {
  return make_model(make_box(8, 3, 3, {0.2, 0.06, 0.06}), tissue(damping),
                    [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
}

inline Model free_bar(double damping = 0) {
  Model model =
      make_model(make_box(8, 3, 3, {0.2, 0.06, 0.06}), tissue(damping), [](const Eigen::Vector3d&) { return false; });
  model.gravity.setZero();
  return model;
}

// Two boxes of that many cells and that size [m] side by side, unconnected, each clamped at its end.
inline Model two_bars(int cells_along, double length, const Material& material) {
  TetMesh mesh = make_box(cells_along, 4, 4, {length, 0.1, 0.1});
  const TetMesh other = mesh;
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Eigen::Vector3d& x : other.positions) mesh.positions.push_back(x + Eigen::Vector3d(0, 0.3, 0));
  for (Tet tet : other.tets) {
    for (std::uint32_t& v : tet) v += offset;
    mesh.tets.push_back(tet);
  }
  mesh.regions.insert(mesh.regions.end(), other.regions.begin(), other.regions.end());
  return make_model(mesh, material, [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
}

/// The same, the first one of linear tets and the second one of quadratic ones.
inline Model linear_and_quadratic_bar(int cells_along, double length, const Material& material) {
  Model model = two_bars(cells_along, length, material);
  const auto half = static_cast<std::uint32_t>(model.tets.size() / 2);
  return quadratic(std::move(model), half);
}

inline SolverSettings with(Method method) {
  SolverSettings settings;
  settings.method = method;
  settings.acceleration = Acceleration::none;
  settings.iterations = 20;
  return settings;
}

inline SolverSettings with(const SolverChoice& pair) {
  SolverSettings settings = with(pair.method);
  settings.acceleration = pair.acceleration;
  return settings;
}

inline Method any_method() { return GENERATE(Method::jacobi, Method::mass_splitting, Method::gauss_seidel); }

// One choice of each kind: common properties are tested with these.
inline SolverChoice any_pair() {
  return GENERATE(
      SolverChoice{Method::jacobi, Acceleration::none}, SolverChoice{Method::mass_splitting, Acceleration::none},
      SolverChoice{Method::gauss_seidel, Acceleration::none}, SolverChoice{Method::exact_xpbd, Acceleration::anderson},
      SolverChoice{Method::vertex_descent, Acceleration::anderson},
      SolverChoice{Method::two_level, Acceleration::anderson},
      SolverChoice{Method::two_level, Acceleration::nonlinear_cg},
      SolverChoice{Method::two_level, Acceleration::subspace});
}

}  // namespace fascia::test
