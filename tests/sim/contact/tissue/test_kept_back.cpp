// Which tissue counts as crushed, and where a tool goes that would press it on.
#include "sim/contact/tissue/kept_back.h"

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

TEST_CASE("the least principal stretch of tets, of quadratic ones that of their points") {
  const bool quadratic = GENERATE(false, true);
  const Model model = one_tet(quadratic);
  CHECK(least_stretch(model, 0, pressed(model, 1)) == Approx(1));
  CHECK(least_stretch(model, 0, pressed(model, 0.08)) == Approx(0.08));
  CHECK(least_stretch(model, 0, pressed(model, -0.5)) == Approx(-0.5));
  // Whatever its volume: pressed flat and made wider.
  std::vector<Vector3d> wide = pressed(model, 0.1);
  for (Vector3d& x : wide) x = x.cwiseProduct(Vector3d(std::sqrt(10), 1, std::sqrt(10)));
  CHECK(least_stretch(model, 0, wide) == Approx(0.1));
  if (!quadratic) return;
  std::vector<Vector3d> bent = pressed(model, 1);
  bent[7].y() -= 0.02;  // the middle of an edge that goes up
  const double least = least_stretch(model, 0, bent);
  CAPTURE(least);
  CHECK(least < 0.9);
}

namespace {

constexpr double kNear = 0.02;

// From the first to where it goes of the way to the other.
Vector3d led(const Model& model, const std::vector<Vector3d>& positions, const Vector3d& from, const Vector3d& to) {
  return kept_back(model, positions, ball(), at(from), at(to), kNear).pose.origin;
}

}  // namespace

TEST_CASE("a tool comes no closer to crushed tissue, and goes along it, away from it or far from it as it is led") {
  const Model model = one_tet(GENERATE(false, true));
  const std::vector<Vector3d> crushed = pressed(model, 0.14), sound = pressed(model, 0.16);
  const Vector3d above(0.0325, 0.03, 0.0325);  // over its middle
  const auto by = [&](double x, double y) { return Vector3d(above + Vector3d(x, y, 0)); };
  CHECK(led(model, crushed, above, by(0, -0.005)) == above);
  CHECK(led(model, sound, above, by(0, -0.005)) == by(0, -0.005));
  CHECK(led(model, crushed, above, by(0, 0.005)) == by(0, 0.005));
  CHECK((led(model, crushed, above, by(0.005, -0.005)) - by(0.005, 0)).norm() < 1e-6);  // along it
  CHECK((led(model, crushed, above, by(-0.005, 0)) - by(-0.005, 0)).norm() < 1e-6);
  const Vector3d far(0.0325, 0.1, 0.0325);
  CHECK(led(model, crushed, far, far + Vector3d(0, -0.005, 0)) == far + Vector3d(0, -0.005, 0));
}

TEST_CASE("jaws do not close on crushed tissue, and open again") {
  const Model model = one_tet(false);
  const std::vector<Vector3d> crushed = pressed(model, 0.08);
  SceneTools scene;
  JawsShape jaws;
  jaws.shape = ToolShape(BoxShape{{0.02, 0.005, 0}, {0.02, 0.005, 0.02}});
  jaws.axis = {0, 0, 1};
  jaws.open_deg = 60;
  scene.instruments.push_back({"forceps", jaws, std::nullopt, {{}}, false});
  const std::vector<Tool> tools = tools_of(scene);
  ToolPlace now = at({0, 0.004, 0.03});
  now.grip = 0.8;
  ToolPlace closer = now, wider = now;
  closer.grip = 0.85;
  wider.grip = 0.75;
  CHECK(kept_back(model, crushed, tools[0], now, closer, kNear) == now);
  CHECK(kept_back(model, crushed, tools[0], now, wider, kNear) == wider);
}
