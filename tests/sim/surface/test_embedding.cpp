// Points embedded in tets: their positions inside, and the limits outside.
#include <catch2/catch.hpp>
#include <random>

#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "sim/surface/embedding.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

Vector3d position(const EmbeddedPoint& tie, const std::vector<Vector3d>& x) {
  Vector3d p = Vector3d::Zero();
  for (int a = 0; a < 4; ++a) p += tie.weights[a] * x[tie.vertices[a]];
  return p;
}

}  // namespace

TEST_CASE("points inside follow the tet around them, points outside the nearest one, within limits") {
  const TetMesh mesh = make_box(6, 5, 4, {0.6, 0.5, 0.4});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.2, 0.8);
  std::vector<Vector3d> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(uniform(random), uniform(random), uniform(random));
  const EmbeddedPoints embedded = embed(points, mesh.positions, mesh.tets);
  REQUIRE(embedded.ties.size() == points.size());
  std::size_t outside = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& p = points[i];
    const Vector3d nearest = p.cwiseMax(Vector3d::Zero()).cwiseMin(Vector3d(0.6, 0.5, 0.4));
    const double distance = (p - nearest).norm();
    outside += distance > 0;
    farthest = std::max(farthest, distance);
    const auto& w = embedded.ties[i].weights;
    CAPTURE(p.transpose(), distance, w[0], w[1], w[2], w[3]);
    CHECK(w[0] + w[1] + w[2] + w[3] == Approx(1));
    const double reach = distance > 0 ? kLargestReach : 0;
    for (const double weight : w) {
      CHECK(weight >= -reach - 1e-9);
      CHECK(weight <= 1 + reach + 1e-9);
    }
    if (distance == 0) CHECK((position(embedded.ties[i], mesh.positions) - p).norm() < 1e-12);
    // Slightly outside, the tet is extrapolated: a quarter of a cell is less than half of any of its heights.
    if (distance < 0.025) CHECK((position(embedded.ties[i], mesh.positions) - p).norm() < 1e-12);
  }
  CHECK(embedded.outside == outside);
  CHECK(embedded.farthest == Approx(farthest));
}

TEST_CASE("points in quadratic tets follow a quadratic motion exactly, and continue it straight outside") {
  TetMesh mesh = make_box(3, 2, 2, {0.6, 0.4, 0.4});
  std::vector<std::uint32_t> all(mesh.tets.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  add_mid_edges(mesh, all);
  const auto motion = [](const Vector3d& x) {
    return Vector3d(x.y() * x.y() - x.x() * x.z(), 0.3 * x.x() * x.x() + x.z(), x.x() * x.y() + 2 * x.z() * x.z());
  };
  const std::vector<Vector3d> points{{0.1, 0.05, 0.2}, {0.33, 0.31, 0.07}, {0.59, 0.39, 0.01}, {0.3, 0.42, 0.2}};
  const EmbeddedPoints embedded = embed(points, mesh.positions, mesh.tets, mesh.mid_edges);
  REQUIRE(embedded.quadratic.size() == points.size());
  CHECK(embedded.outside == 1);
  std::vector<Vector3d> of_vertices;
  for (const Vector3d& x : mesh.positions) of_vertices.push_back(motion(x));
  const std::vector<Vector3d> moved = at_points(embedded, of_vertices);
  REQUIRE(moved.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const QuadraticTie& tie = embedded.quadratic[i];
    Vector3d u = Vector3d::Zero(), rest = Vector3d::Zero();
    const auto add = [&](std::uint32_t v, double weight) {
      u += weight * motion(mesh.positions[v]);
      rest += weight * mesh.positions[v];
    };
    for (std::size_t a = 0; a < 4; ++a) add(embedded.ties[i].vertices[a], tie.weights[a]);
    for (std::size_t m = 0; m < 6; ++m) add(tie.middles[m], tie.weights[4 + m]);
    CAPTURE(points[i].transpose(), u.transpose(), motion(points[i]).transpose());
    CHECK((rest - points[i]).norm() < 1e-12);
    Vector3d expected = motion(points[i]);
    if (i == 3) {  // from the foot (0.3, 0.4, 0.2) along y by 0.02
      const Vector3d foot(0.3, 0.4, 0.2), along(2 * foot.y(), 0, foot.x());
      expected = motion(foot) + 0.02 * along;
    }
    CHECK((u - expected).norm() < 1e-12);
    CHECK((moved[i] - expected).norm() < 1e-12);
  }
}

TEST_CASE("bodies of both elements are embedded in one list") {
  const TetMesh linear = make_box(2, 2, 2, {1, 1, 1});
  TetMesh curved = linear;
  std::vector<std::uint32_t> all(curved.tets.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  add_mid_edges(curved, all);
  const EmbeddedPoints a = embed({{0.2, 0.3, 0.4}}, linear.positions, linear.tets),
                       b = embed({{0.7, 0.3, 0.4}}, curved.positions, curved.tets, curved.mid_edges);
  CHECK(a.quadratic.empty());
  for (const bool quadratic_first : {false, true}) {
    EmbeddedPoints points = quadratic_first ? b : a;
    append(points, quadratic_first ? a : b);
    append(points, a);
    REQUIRE(points.quadratic.size() == 3);
    const std::size_t of_linear = quadratic_first ? 1 : 0;
    CHECK(points.quadratic[of_linear].middles == kNoMidEdges);
    CHECK(points.quadratic[1 - of_linear].middles == b.quadratic[0].middles);
    CHECK(points.quadratic[2].weights[0] == a.ties[0].weights[0]);
    CHECK(points.quadratic[2].weights[9] == 0);
    // The vertices of both boxes have the same numbers, as far as the linear one has them.
    const std::vector<Vector3d> places = at_points(points, curved.positions);
    for (std::size_t i = 0; i < 3; ++i) CHECK((places[i] - points.points[i]).norm() < 1e-14);
  }
  EmbeddedPoints points = a;
  append(points, a);
  CHECK(points.quadratic.empty());
  CHECK(points.ties.size() == 2);
  for (const Vector3d& place : at_points(points, linear.positions)) CHECK((place - a.points[0]).norm() < 1e-14);
}
