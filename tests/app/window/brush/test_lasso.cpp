// A closed curve in the picture, and the vertices and tets within it.
#include "app/window/brush/lasso.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/mesh/tet_faces.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr BrushedPicture kWidePicture{600, 400};
const std::vector<Vector2d> kAll{{-10, -10}, {610, -10}, {610, 410}, {-10, 410}};

struct FacedCube {
  Graphics graphics = open_graphics(headless(), false);
  Session session{graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false};
  const Model& model() const { return session.simulation.model; }
  /// Looks at the cube along -z, at the middle of the picture.
  FacedCube() {
    session.camera.eye = session.look.center + Vector3d(0, 0, 8 * session.look.radius);
    session.camera.target = session.look.center;
  }
  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Tet& tet : model().tets)
      for (const std::uint32_t v : tet) box.extend(model().rest_positions[v]);
    return box;
  }
};

}  // namespace

TEST_CASE("a lasso keeps the places of its way, and is empty afterwards") {
  Lasso lasso;
  lasso.move({3, 3});
  CHECK_FALSE(lasso.drawing());
  lasso.begin({10, 10});
  lasso.move({10.5, 10});  // too near
  lasso.move({20, 10});
  lasso.move({20, 20});
  CHECK(lasso.drawing());
  CHECK(lasso.curve() == std::vector<Vector2d>{{10, 10}, {20, 10}, {20, 20}});
  CHECK(lasso.finish().size() == 3);
  CHECK_FALSE(lasso.drawing());
}

TEST_CASE("a lasso around everything takes the vertices of the side that is seen") {
  FacedCube cube;
  const std::vector<std::uint32_t> seen = vertices_within(kAll, kWidePicture, cube.session);
  const double front = cube.box().max().z();
  std::vector<std::uint32_t> expected;
  for (const Triangle& t : boundary_triangles(cube.model().tets))
    for (const std::uint32_t v : t)
      if (std::abs(cube.model().rest_positions[v].z() - front) < 1e-9) expected.push_back(v);
  std::sort(expected.begin(), expected.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  REQUIRE_FALSE(expected.empty());
  CHECK(seen == expected);

  INFO("a curve around the left half of the picture");
  const std::vector<Vector2d> left{{-10, -10}, {300, -10}, {300, 410}, {-10, 410}};
  for (const std::uint32_t v : vertices_within(left, kWidePicture, cube.session))
    CHECK(cube.model().rest_positions[v].x() <= cube.session.look.center.x() + 1e-6);
  CHECK(vertices_within({{1, 1}, {20, 1}, {20, 20}}, kWidePicture, cube.session).empty());  // beside the tissue
  CHECK(vertices_within({{300, 200}, {301, 200}}, kWidePicture, cube.session).empty());     // no area
}

TEST_CASE("a lasso takes tets to a depth behind the visible side, or all of them") {
  FacedCube cube;
  const std::vector<Tet>& tets = cube.model().tets;
  CHECK(tets_within(kAll, kWidePicture, cube.session, std::nullopt).size() == tets.size());
  const auto corner_depth = [&](std::uint32_t t) {
    double depth = 1e9;
    for (const std::uint32_t v : tets[t])
      depth = std::min(depth, cube.box().max().z() - cube.model().rest_positions[v].z());
    return depth;
  };
  const double half = 0.5 * cube.box().sizes().z();
  for (const double depth : {0.0, half}) {
    CAPTURE(depth);
    const std::vector<std::uint32_t> taken = tets_within(kAll, kWidePicture, cube.session, depth);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t t = 0; t < tets.size(); ++t)
      if (corner_depth(t) <= depth + 0.002 * cube.session.look.radius) expected.push_back(t);
    REQUIRE_FALSE(expected.empty());
    REQUIRE(expected.size() < tets.size());
    CHECK(taken == expected);
  }
}

TEST_CASE("a lasso on a section plane begins at the cut and leaves what is cut away") {
  FacedCube cube;
  DisplaySettings display = cube.session.display();
  const double cut = cube.session.look.center.z();
  display.section = SectionPlane{{0, 0, 1}, 0};
  cube.session.set_display(display);
  REQUIRE(shown_cut(cube.session.look)->offset == Approx(cut).margin(1e-6));
  const std::vector<std::uint32_t> taken = tets_within(kAll, kWidePicture, cube.session, 0.0);
  REQUIRE_FALSE(taken.empty());
  const std::vector<Vector3d> centers = centroids_of(cube.model().tets, cube.model().rest_positions);
  for (const std::uint32_t t : taken) {
    CHECK(centers[t].z() <= cut + 1e-6);
    double highest = -1e9;
    for (const std::uint32_t v : cube.model().tets[t]) highest = std::max(highest, cube.model().rest_positions[v].z());
    CHECK(highest >= cut - 0.002 * cube.session.look.radius - 1e-6);
  }
  for (const std::uint32_t v : vertices_within(kAll, kWidePicture, cube.session))
    CHECK(cube.model().rest_positions[v].z() <= cut + 1e-6);
}
