// Quadratic tets cut into linear ones.
#include <catch2/catch.hpp>

#include "sim/mesh/linear_tets.h"
#include "sim/mesh/tet_faces.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

double volume(const Tet& tet, const std::vector<Vector3d>& x) {
  return (x[tet[1]] - x[tet[0]]).cross(x[tet[2]] - x[tet[0]]).dot(x[tet[3]] - x[tet[0]]) / 6;
}

}  // namespace

TEST_CASE("the parts of a quadratic tet fill it, whatever its shortest diagonal") {
  const Vector3d stretch = GENERATE(Vector3d(1, 1, 1), Vector3d(5, 1, 1), Vector3d(1, 5, 1), Vector3d(1, 1, 5));
  std::vector<Vector3d> x{{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {0.3, 0.4, 1}};
  for (Vector3d& p : x) p = p.cwiseProduct(stretch);
  for (const auto& [a, b] : kMidEdgeCorners) x.push_back((x[a] + x[b]) / 2);
  const Tet whole{0, 1, 2, 3};
  double sum = 0;
  for (const Tet& part : cut_in_eight(whole, {4, 5, 6, 7, 8, 9}, x)) {
    CAPTURE(part, volume(part, x));
    CHECK(volume(part, x) == Approx(volume(whole, x) / 8).epsilon(1e-12));
    sum += volume(part, x);
  }
  CHECK(sum == Approx(volume(whole, x)).epsilon(1e-12));
}

TEST_CASE("a cut mesh has the boundary of the quadratic one, in four triangles a face") {
  const Model linear =
      make_model(make_box(3, 2, 2, {0.3, 0.2, 0.2}), Material(), [](const Vector3d&) { return false; });
  const Model model = quadratic(linear);
  const auto cut = [](const Model& m) { return linear_tets(m.tets, m.mid_edges, m.rest_positions, 0, m.tets.size()); };
  const LinearTets parts = cut(model);
  REQUIRE(parts.tets.size() == 8 * model.tets.size());
  CHECK(parts.source[9] == 1);
  CHECK(boundary_triangles(parts.tets).size() == 4 * boundary_triangles(model.tets).size());
  CHECK(cut(linear).tets == linear.tets);
}
