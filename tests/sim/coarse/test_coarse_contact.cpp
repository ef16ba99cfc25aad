#include "sim/coarse/coarse_contact.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/coarse/coarse_matrix.h"
#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::MatrixXf;
using Eigen::Vector3d;
using Eigen::VectorXf;

TEST_CASE("pushing back solves the coarse problem with the stiffness of contact", "[coarse]") {
  const Model model = test::box_model(6, 6, 6, {0.2, 0.2, 0.2}, test::soft(1e5));
  const CoarseSpace space = make_coarse_space(model, 40);
  REQUIRE(space.node_count > 8);
  constexpr double kStep = 1.0 / 60;
  const MatrixXf matrix = coarse_matrix(model, space, kStep).cast<float>(), inverse = matrix.inverse();

  // The bottom presses, and two edges stick to each other.
  std::vector<PointStiffness> points;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].y() < 1e-9)
      points.push_back({{v, v, v, v}, {1, 0, 0, 0}, 2e4 * Vector3d::UnitY() * Vector3d::UnitY().transpose()});
  points.push_back({{0, 1, 7, 8}, {0.5, 0.5, -0.25, -0.75}, 1e3 * Eigen::Matrix3d::Identity()});
  test::Random random(2);
  std::vector<Eigen::Quaternionf> rotations;
  for (std::uint32_t j = 0; j < space.node_count; ++j)
    rotations.emplace_back(Eigen::Quaterniond(random.rotation()).cast<float>());

  PointFunctions functions;
  const TouchedNodes contact = touched_nodes(space, functions, points, rotations, kStep);
  const MatrixXf stiffness = stiffness_between(contact.nodes, space, functions, points, rotations, kStep);
  const auto nodes = static_cast<Eigen::Index>(contact.nodes.size());
  REQUIRE(nodes > 0);
  REQUIRE(nodes < static_cast<Eigen::Index>(space.node_count));
  CAPTURE((contact.stiffness - stiffness.diagonal()).cwiseAbs().maxCoeff(), stiffness.diagonal().maxCoeff());
  CHECK(contact.stiffness.isApprox(stiffness.diagonal(), 1e-5f));
  MatrixXf whole = matrix, spread = MatrixXf::Zero(matrix.rows(), 3 * nodes);
  for (Eigen::Index k = 0; k < nodes; ++k)
    spread.block<3, 3>(3 * contact.nodes[static_cast<std::size_t>(k)], 3 * k).setIdentity();
  whole += spread * stiffness * spread.transpose();

  const Eigen::VectorXf right = random.vector(matrix.rows()).cast<float>(), exact = whole.lu().solve(right);
  const Eigen::VectorXf free = inverse * right;
  NodeCompliance compliance =
      compliance_of(contact.nodes, [&](Eigen::Index i, Eigen::Index k) { return inverse(i, k); });
  REQUIRE(compliance.inverse.rows() == 3 * nodes);
  const MatrixXf push = push_back(stiffness, compliance);
  const Eigen::VectorXf found = free - inverse * (spread * (push * (spread.transpose() * free)));
  CAPTURE(nodes, exact.norm(), free.norm(), (found - exact).norm());
  CHECK((free - exact).norm() > 0.1 * exact.norm());
  CHECK((found - exact).norm() < 2e-3 * exact.norm());  // of float32, with a condition of some thousands

  // Without the inverse, as where rounding leaves the compliance indefinite, the same to a share of what C holds.
  compliance.inverse = {};
  const MatrixXf otherwise = push_back(stiffness, compliance);
  CAPTURE((push - otherwise).norm(), push.norm());
  CHECK((push - otherwise).norm() < 1e-3f * push.norm());

  // The same energy as that of the points themselves, for motions of the coarse space.
  const Eigen::VectorXf z = random.vector(matrix.rows()).cast<float>();
  double energy = 0;
  for (const PointStiffness& point : points) {
    Vector3d at(0, 0, 0);
    for (std::size_t a = 0; a < 4; ++a)
      for (std::uint32_t e = space.begin[point.vertices[a]]; e < space.begin[point.vertices[a] + 1]; ++e)
        at += point.weights[a] * space.weight[e] *
              (rotations[space.node[e]] * Eigen::Vector3f(z.segment<3>(3 * space.node[e]))).cast<double>();
    energy += kStep * kStep * at.dot(point.stiffness * at);
  }
  const Eigen::VectorXf touched = spread.transpose() * z;
  CHECK(touched.dot(stiffness * touched) == Approx(energy).epsilon(1e-4));
}

// A stiff body that nothing holds: its compliance as a whole is many times that of its deformations, whose roundings
// the inverse takes for stiffness. Coarse corrections were up to some thousand times the step so, and no numbers in
// some.
TEST_CASE("what contact leaves of its stiffness is between nothing and all of it", "[coarse]") {
  constexpr Eigen::Index kSize = 24;
  test::Random random(3);
  std::vector<std::uint32_t> nodes(kSize / 3);
  std::iota(nodes.begin(), nodes.end(), 0u);
  for (const double whole : {1e2, 1e3, 3e3, 1e4, 2e4, 3e4, 5e4, 1e5, 2e5, 3e5, 5e5, 1e6, 1e8}) {
    const Eigen::VectorXd rigid = random.vector(kSize);
    Eigen::MatrixXd half(kSize, kSize);
    for (Eigen::Index k = 0; k < kSize; ++k) half.col(k) = random.vector(kSize);
    const MatrixXf compliance =
        (whole * rigid * rigid.transpose() + 1e-2 * half * half.transpose()).eval().cast<float>();
    for (Eigen::Index k = 0; k < kSize; ++k)
      half.col(k) = k < kSize / 2 ? random.vector(kSize) : Eigen::VectorXd::Zero(kSize);
    const MatrixXf stiffness = (1e3 * half * half.transpose()).eval().cast<float>();
    const MatrixXf left =
        push_back(stiffness, compliance_of(nodes, [&](Eigen::Index i, Eigen::Index k) { return compliance(i, k); }));
    const float largest = stiffness.norm();
    const Eigen::SelfAdjointEigenSolver<MatrixXf> of_left(left), of_rest(stiffness - left);
    CAPTURE(whole, largest, of_left.eigenvalues().minCoeff(), of_rest.eigenvalues().minCoeff());
    CHECK(left.allFinite());
    CHECK(of_left.eigenvalues().minCoeff() > -2e-2f * largest);
    CHECK(of_rest.eigenvalues().minCoeff() > -2e-2f * largest);
  }
}

TEST_CASE("a compliance that is indefinite by rounding has no inverse", "[coarse]") {
  MatrixXf nearly = MatrixXf::Identity(3, 3);
  nearly(0, 1) = nearly(1, 0) = 1.0001f;
  const NodeCompliance compliance = compliance_of({0}, [&](Eigen::Index i, Eigen::Index k) { return nearly(i, k); });
  CHECK(compliance.inverse.size() == 0);
  const MatrixXf push = push_back(2 * MatrixXf::Identity(3, 3), compliance);
  CHECK((push + 2 * nearly * push).isApprox(2 * MatrixXf::Identity(3, 3), 1e-5f));
}

TEST_CASE("functions of numbered points are kept", "[coarse]") {
  CoarseSpace space;
  space.node_count = 3;
  space.begin = {0, 2, 4};
  space.node = {0, 2, 0, 1};
  space.weight = {0.25, 0.75, 0.5, 0.5};
  PointFunctions functions;
  PointStiffness point{{0, 1, 0, 0}, {0.5, 0.5, 0, 0}, Eigen::Matrix3d::Identity(), 4};
  const std::vector<PointFunctions::Function> expected{{0, 0.375}, {1, 0.25}, {2, 0.375}};
  for (int i = 0; i < 2; ++i) {
    const auto at = functions.at(space, point);
    CHECK(std::vector(at.begin(), at.end()) == expected);
    point.weights = {1, 0, 0, 0};  // not looked at: the number says it all
  }
  point.number = PointStiffness::kUnnumbered;
  CHECK(functions.at(space, point).size() == 2);
}

TEST_CASE("contact that holds hardly otherwise serves again", "[coarse]") {
  const auto soft = [](Eigen::Index) { return 0.5f; };  // c g = 0.5: a third of a coordinate is held
  TouchedNodes a{{1, 2}, VectorXf::Ones(6)}, b = a;
  CHECK(alike(a, b, soft));
  b.stiffness *= 1.1f;  // c g / (1 + c g): 0.3548 for 0.3333
  CHECK(alike(a, b, soft));
  b.stiffness *= 1.2f;  // 0.3976
  CHECK_FALSE(alike(a, b, soft));
  CHECK(alike(a, b, [](Eigen::Index) { return 50.0f; }));  // 0.9851 for 0.9804
  b = a;
  b.nodes = {1, 3};
  CHECK_FALSE(alike(a, b, soft));
  CHECK_FALSE(alike(b, a, soft));

  // A node that is hardly held may come and go.
  b = {{1, 2, 4}, VectorXf::Ones(9)};
  b.stiffness.tail<3>().setConstant(0.01f);
  CHECK(alike(a, b, soft));
  CHECK(alike(b, a, soft));
  CHECK_FALSE(alike(a, {}, soft));
  CHECK_FALSE(alike({}, a, soft));
}

}  // namespace
}  // namespace fascia
