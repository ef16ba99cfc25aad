// Points embedded in tets: their positions inside, and the limits outside.
#include <catch2/catch.hpp>
#include <random>

#include "sim/mesh/mesh_generate.h"
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
