#include "sim/reference/elastic_system.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "sim/material/symmetric_eigen.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::Random;
using test::soft;

// Two materials, one of them viscous, one end fixed, one vertex prescribed, one vertex in no tet.
Model test_box() {
  Model model =
      test::box_model(2, 2, 1, {0.2, 0.2, 0.1}, soft(1e5, 0.3), [](const Vector3d& x) { return x.x() < 0.01; });
  model.materials.push_back(soft(3e5, 0.45, 0.02));
  for (std::size_t t = 0; t < model.tets.size(); t += 2) model.tet_material[t] = 1;
  Motion motion;
  motion.vertices = {static_cast<std::uint32_t>(model.rest_positions.size() - 1)};
  model.motions.push_back(motion);
  model.rest_positions.push_back({5, 5, 5});
  model.initial_velocity.push_back({0, 0, 0});
  return model;
}

MatrixXd dense(const SparseMatrix& upper) { return MatrixXd(upper).selfadjointView<Eigen::Upper>(); }

TEST_CASE("unknowns are the free vertices that tets use", "[elastic_system]") {
  const Model model = test_box();
  const ElasticSystem system(model);
  const std::vector<char> held = model.held();
  std::vector<char> seen(system.dof_count(), 0);
  for (std::size_t v = 0; v < held.size(); ++v) {
    const int first = system.first_dof()[v];
    CAPTURE(v, first);
    CHECK((first < 0) == (held[v] || v == held.size() - 1));
    if (first < 0) continue;
    REQUIRE(first + 2 < system.dof_count());
    for (int c = 0; c < 3; ++c) {
      CHECK(!seen[first + c]);
      seen[first + c] = 1;
    }
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == system.dof_count());
}

TEST_CASE("the assembled gradient and Hessian are the derivatives of the energy", "[elastic_system]") {
  const Model model = test_box();
  const ElasticSystem system(model);
  Random random(11);
  const VectorXd u = 0.008 * random.vector(3 * model.rest_positions.size());
  const ViscousStep viscous{system.strains(0.004 * random.vector(u.size())), 0.01};
  VectorXd gradient, scale, unused;
  system.evaluate(u, viscous, gradient);
  SparseMatrix hessian = system.empty_hessian();
  system.assemble(u, viscous, false, hessian, scale);
  const MatrixXd exact = dense(hessian);

  // Five-point stencils are exact for this quartic energy.
  const double step = 1e-3;
  for (const std::size_t v : {std::size_t{5}, std::size_t{8}, std::size_t{16}})
    for (int c = 0; c < 3; ++c) {
      const std::size_t i = 3 * v + c;
      VectorXd differences = VectorXd::Zero(u.size());
      double slope = 0;
      for (const auto& [factor, weight] : {std::pair{1, 8}, {-1, -8}, {2, -1}, {-2, 1}}) {
        VectorXd moved = u, moved_gradient;
        moved[i] += factor * step;
        slope += weight * system.evaluate(moved, viscous, moved_gradient) / (12 * step);
        differences += weight * moved_gradient / (12 * step);
      }
      CAPTURE(v, c);
      CHECK(slope == Approx(gradient[i]).epsilon(1e-9));
      CHECK((system.hessian_times(u, viscous, VectorXd::Unit(u.size(), i)) - differences).norm() <
            1e-10 * differences.norm());
      if (system.first_dof()[v] < 0) continue;
      CHECK((exact.col(system.first_dof()[v] + c) - system.free_part(differences)).norm() < 1e-10 * differences.norm());
    }
}

TEST_CASE("assembling twice gives the same bits, projecting a positive definite matrix", "[elastic_system]") {
  const Model model = test_box();
  const ElasticSystem system(model);
  Random random(12);
  const VectorXd u = 0.03 * random.vector(3 * model.rest_positions.size());
  SparseMatrix first = system.empty_hessian(), second = system.empty_hessian(), projected = system.empty_hessian();
  VectorXd scale;
  system.assemble(u, {}, false, first, scale);
  system.assemble(0.5 * u, {}, false, second, scale);
  system.assemble(u, {}, false, second, scale);
  CHECK(dense(first) == dense(second));
  system.assemble(u, {}, true, projected, scale);
  const double before = symmetric_eigen(dense(first)).values[0];
  const double after = symmetric_eigen(dense(projected)).values[0];
  CAPTURE(before, after);
  CHECK(before < 0);  // otherwise nothing was tested
  CHECK(after > 0);
}

TEST_CASE("internal forces of a free mesh sum to no force and no torque", "[elastic_system]") {
  const Model model = test_box();
  const ElasticSystem system(model);
  Random random(13);
  const VectorXd u = 0.01 * random.vector(3 * model.rest_positions.size());
  VectorXd gradient;
  system.evaluate(u, {system.strains(0.3 * u), 0.01}, gradient);
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    force += gradient.segment<3>(3 * v);
    torque += (model.rest_positions[v] + u.segment<3>(3 * v)).cross(gradient.segment<3>(3 * v));
  }
  CAPTURE(gradient.norm(), force.transpose(), torque.transpose());
  CHECK(gradient.norm() > 1);
  CHECK(force.norm() < 1e-13 * gradient.norm());
  CHECK(torque.norm() < 1e-13 * gradient.norm());
}

}  // namespace
}  // namespace fascia::reference
