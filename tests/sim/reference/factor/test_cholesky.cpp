#include "sim/reference/factor/cholesky.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "sim/reference/elastic_system.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct Hessian {
  SparseMatrix upper;
  MatrixXd whole;
};

// At rest: positive semidefinite, singular without constraints.
Hessian hessian_of(const ElasticSystem& system, const Model& model) {
  Hessian h{system.empty_hessian(), {}};
  VectorXd scale = VectorXd::Zero(static_cast<Eigen::Index>(3 * model.rest_positions.size()));
  system.assemble(VectorXd::Zero(scale.size()), {}, false, h.upper, scale);
  h.whole = MatrixXd(h.upper).selfadjointView<Eigen::Upper>();
  return h;
}

// Two boxes, one unconstrained, the other one fixed at an end.
Model two_boxes() {
  Model model =
      test::box_model(9, 4, 4, {0.9, 0.4, 0.4}, test::soft(1e5), [](const Vector3d& x) { return x.x() < 1e-9; });
  const Model other = test::box_model(3, 4, 5, {0.3, 0.4, 0.5}, test::soft(1e5), [](const Vector3d&) { return false; });
  const auto first = static_cast<std::uint32_t>(model.rest_positions.size());
  for (const Vector3d& x : other.rest_positions) model.rest_positions.push_back(x + Vector3d(2, 0, 0));
  for (const Tet& tet : other.tets)
    model.tets.push_back({tet[0] + first, tet[1] + first, tet[2] + first, tet[3] + first});
  model.tet_material.resize(model.tets.size(), 0);
  model.initial_velocity.resize(model.rest_positions.size(), Vector3d::Zero());
  return model;
}

void check_solution(const Hessian& h, const Cholesky& cholesky, double shift) {
  const MatrixXd whole = h.whole + shift * MatrixXd::Identity(h.whole.rows(), h.whole.cols());
  test::Random random(7);
  VectorXd expected(whole.rows());
  for (double& x : expected) x = random();
  const VectorXd right = whole * expected, found = cholesky.solve(right);
  CAPTURE((whole * found - right).norm() / right.norm());
  CHECK((whole * found - right).norm() <= 1e-13 * right.norm());  // backward stable: some hundred roundings
}

TEST_CASE("the factor solves the system, for one tet, a beam, a block and two bodies", "[cholesky]") {
  const auto end = [](const Vector3d& x) { return x.x() < 1e-9; };
  const Model model = GENERATE_COPY(test::box_model(1, 1, 1, {0.1, 0.1, 0.1}, test::soft(1e5), end),
                                    test::box_model(60, 2, 2, {3, 0.1, 0.1}, test::soft(1e5), end),
                                    test::box_model(7, 7, 7, {0.3, 0.3, 0.3}, test::soft(1e5, 0.45), end), two_boxes());
  const ElasticSystem system(model);
  const Hessian h = hessian_of(system, model);
  CAPTURE(system.dof_count());
  Cholesky cholesky(system.empty_hessian(), system.elimination_tree());
  const double shift = 1e-3 * h.whole.diagonal().maxCoeff();
  REQUIRE(cholesky.factorize(h.upper, shift));
  check_solution(h, cholesky, shift);
  REQUIRE(cholesky.factorize(h.upper, 2 * shift));  // again, with other values
  check_solution(h, cholesky, 2 * shift);
}

TEST_CASE("a matrix that is not positive definite has no factor", "[cholesky]") {
  const Model model = two_boxes();
  const ElasticSystem system(model);
  Hessian h = hessian_of(system, model);
  Cholesky cholesky(system.empty_hessian(), system.elimination_tree());
  const double largest = h.whole.diagonal().maxCoeff();
  CHECK_FALSE(cholesky.factorize(h.upper, -0.1 * largest));
  CHECK(cholesky.factorize(h.upper, 1e-6 * largest));
  for (const int place : {0, system.dof_count() / 2, system.dof_count() - 1}) {  // one bad pivot, at any place
    SparseMatrix spoiled = h.upper;
    spoiled.coeffRef(place, place) = -1;
    CAPTURE(place);
    CHECK_FALSE(cholesky.factorize(spoiled, 1e-6 * largest));
  }
}

TEST_CASE("nothing to eliminate, nothing to solve", "[cholesky]") {
  Cholesky nothing(SparseMatrix(), nested_dissection({}, {}));
  CHECK(nothing.factorize(SparseMatrix()));
  CHECK(nothing.solve(VectorXd()).size() == 0);
}

}  // namespace
}  // namespace fascia::reference
