#include "sim/bare_mesh/flat_sides.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "sim/mesh/mesh_generate.h"
#include "tests/support/bare_shapes.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("every side of a box is flat, and carries it by its proportions") {
  const TetMesh box = make_box(2, 3, 4, {0.1, 0.4, 0.2});
  const FlatSides sides = flat_sides(box.positions, box.tets);
  CHECK((sides.size - Eigen::Vector3d(0.1, 0.4, 0.2)).norm() < 1e-15);
  for (const auto* side : {&sides.low, &sides.high}) {
    CHECK((*side)[0].area == Approx(0.08));
    CHECK((*side)[1].area == Approx(0.02));
    CHECK((*side)[2].area == Approx(0.04));
    for (const FlatSide& s : *side) CHECK(s.share == Approx(1));
    CHECK((*side)[1].stability == Approx(0.25));  // 0.05 beside the center, 0.2 above the ground
    CHECK((*side)[0].stability == Approx(2));
  }
}

TEST_CASE("a ball has no flat side, a cone one") {
  const TetMesh ball = make_ball(0.1);
  const FlatSides round = flat_sides(ball.positions, ball.tets);
  for (const auto* side : {&round.low, &round.high})
    for (const FlatSide& s : *side) CHECK(s.share < 0.1);
  const TetMesh cone = make_cone(0.05, 0.1);
  const FlatSides sides = flat_sides(cone.positions, cone.tets);
  CHECK(sides.low[1].share == Approx(std::numbers::pi / 4).epsilon(0.05));
  CHECK(sides.low[1].stability == Approx(2).epsilon(0.1));  // 0.05 beside its center, 0.025 above the ground
  CHECK(sides.high[1].share < 0.01);
}

TEST_CASE("a flat side may have a rim that stands out, as fills of surfaces have") {
  const double rim = GENERATE(0.0, 0.012, 0.03);
  TetMesh box = make_box(8, 8, 8, {0.4, 0.4, 0.4});
  for (Eigen::Vector3d& p : box.positions) {
    const bool outer = std::min({p.x(), p.z(), 0.4 - p.x(), 0.4 - p.z()}) < 1e-9;
    if (outer && p.y() < 1e-9) p.y() -= rim;
  }
  const FlatSides sides = flat_sides(box.positions, box.tets);
  CAPTURE(rim, sides.low[1].share, sides.low[1].depth);
  CHECK(sides.low[1].share > 0.5);
  CHECK(sides.low[1].depth == Approx(rim == 0 ? 0 : rim / (0.4 + rim)).margin(1e-9));
  CHECK(sides.high[1].depth == 0);
}

TEST_CASE("center, volume and box are those of the tets") {
  TetMesh box = make_box(3, 2, 1, {3, 2, 1});
  box.positions.emplace_back(100, 0, 0);
  const Bulk bulk = bulk_of(box.positions, box.tets);
  CHECK(bulk.volume == Approx(6));
  CHECK((bulk.center - Eigen::Vector3d(1.5, 1, 0.5)).norm() < 1e-14);
  CHECK(bulk.box.max() == Eigen::Vector3d(3, 2, 1));
}
