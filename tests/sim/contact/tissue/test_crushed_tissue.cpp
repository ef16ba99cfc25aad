// Which tissue counts as crushed, and which ways of a tool press it on.
#include "sim/contact/tissue/crushed_tissue.h"

#include <catch2/catch.hpp>

#include "tests/support/support.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

// A tet of 0.1 m with one vertex above the others, and a ball that may press it down.
Model one_tet(bool quadratic) {
  Model model;
  model.rest_positions = {{0, 0, 0}, {0, 0, 0.1}, {0.1, 0, 0}, {0.03, 0.1, 0.03}};
  model.tets = {{0, 1, 2, 3}};
  if (!quadratic) return model;
  model.mid_edges = {{4, 5, 6, 7, 8, 9}};
  for (const auto& [a, b] : kMidEdgeCorners)
    model.rest_positions.push_back(0.5 * (model.rest_positions[a] + model.rest_positions[b]));
  return model;
}

std::vector<Vector3d> pressed(const Model& model, double share) {
  std::vector<Vector3d> positions = model.rest_positions;
  for (Vector3d& x : positions) x.y() *= share;
  positions.emplace_back(7, 7, 7);  // of a drawn surface
  return positions;
}

const Tool& ball() {
  static const std::vector<Tool> tools = [] {
    SceneTools scene;
    scene.instruments.push_back({"ball", ToolShape(SphereShape{{0, 0, 0}, 0.02}), std::nullopt, {{}}, false});
    return tools_of(scene);
  }();
  return tools[0];
}

ToolPlace at(const Vector3d& place) {
  ToolPlace here;
  here.pose.origin = place;
  return here;
}

}  // namespace

TEST_CASE("the volume ratio of tets, of quadratic ones the least of their points") {
  const bool quadratic = GENERATE(false, true);
  const Model model = one_tet(quadratic);
  CHECK(least_volume_ratio(model, 0, pressed(model, 1)) == Approx(1));
  CHECK(least_volume_ratio(model, 0, pressed(model, 0.08)) == Approx(0.08));
  CHECK(least_volume_ratio(model, 0, pressed(model, -0.5)) == Approx(-0.5));
  if (!quadratic) return;
  std::vector<Vector3d> bent = pressed(model, 1);
  bent[7].y() -= 0.02;  // the middle of an edge that goes up
  const double least = least_volume_ratio(model, 0, bent);
  CAPTURE(least);
  CHECK(least < 0.9);
}

TEST_CASE("a tool presses crushed tissue where it comes closer to it, not beside it, away from it or far from it") {
  const Model model = one_tet(GENERATE(false, true));
  const std::vector<Vector3d> crushed = pressed(model, 0.08), sound = pressed(model, 0.12);
  const ToolPlace above = at({0.03, 0.03, 0.03}), lower = at({0.03, 0.025, 0.03}), higher = at({0.03, 0.035, 0.03}),
                  beside = at({0.04, 0.03, 0.03});
  constexpr double kNear = 0.02;
  CHECK(presses_crushed_tissue(model, crushed, ball(), above, lower, kNear));
  CHECK(!presses_crushed_tissue(model, sound, ball(), above, lower, kNear));
  CHECK(!presses_crushed_tissue(model, crushed, ball(), above, above, kNear));
  CHECK(!presses_crushed_tissue(model, crushed, ball(), above, higher, kNear));
  CHECK(!presses_crushed_tissue(model, crushed, ball(), above, beside, kNear));
  CHECK(!presses_crushed_tissue(model, crushed, ball(), at({0.03, 0.1, 0.03}), lower, kNear));
}
