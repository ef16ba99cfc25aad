#include "sim/contact/passing/clear_way.h"

#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

TEST_CASE("a point goes through a plate however fast it is, and not along it or out of it", "[contact]") {
  const ToolShape plate = BoxShape{{0, -0.0005, 0}, {0.1, 0.0005, 0.1}};
  for (const double down : {0.003, 0.1, 10.0}) CHECK(goes_through(plate, {0.01, 0.001, 0}, {0.013, -down, 0}, 0));
  CHECK(goes_through(plate, {0, 3, 0}, {0, -0.0009, 0}, 0));          // its far side is nearer
  CHECK(goes_through(plate, {0, -1e-6, 0}, {0, -0.1, 0}, 0));         // pressed in by a little before
  CHECK_FALSE(goes_through(plate, {0, 0.1, 0}, {0, -0.0001, 0}, 0));  // pressed in by a little
  CHECK_FALSE(goes_through(plate, {0, 0.001, 0}, {0.09, 0, 0}, 0));
  CHECK_FALSE(goes_through(plate, {0.2, 0.1, 0}, {0.2, -0.1, 0}, 0));  // beside it
  CHECK_FALSE(goes_through(plate, {0, -0.0005, 0}, {0, -0.1, 0}, 0));  // from its middle
  CHECK_FALSE(goes_through(PlaneShape{{0, 0, 0}, {0, 1, 0}}, {0, 1, 0}, {0, -1, 0}, 0));
}

// [3 * vertex_count] of the second body.
VectorXd moved_by(const Model& model, const Vector3d& way) {
  VectorXd u = VectorXd::Zero(static_cast<Eigen::Index>(3 * model.rest_positions.size()));
  for (std::size_t v = model.bodies[1].vertex_begin; v < model.rest_positions.size(); ++v)
    u.segment<3>(static_cast<Eigen::Index>(3 * v)) = way;
  return u;
}

TEST_CASE("a body goes through another one by its vertices, by the other's, or by edges alone", "[contact]") {
  const Material material = test::soft(1e5);
  const Model cube = test::box_model(1, 1, 1, {0.1, 0.1, 0.1}, material);
  struct Case {
    Vector3d size, place, beyond, before, beside;
  };
  for (const Case& c : {Case{{0.02, 0.02, 0.02}, {0.03, 0.12, 0.04}, {0, -0.2, 0}, {0, -0.015, 0}, {0.5, -0.05, 0}},
                        Case{{0.4, 0.02, 0.4}, {-0.15, 0.12, -0.16}, {0, -0.2, 0}, {0, -0.015, 0}, {0.5, 0.2, 0}},
                        Case{{0.4, 0.02, 0.02}, {-0.15, 0.12, 0.04}, {0, -0.2, 0}, {0, -0.015, 0}, {0, -0.05, 0.5}}}) {
    const Model model = test::beside(cube, test::moved(test::box_model(1, 1, 1, c.size, material), c.place), "second");
    const ContactSurface none;
    ClearWay clear(model, none, 0.001);
    const VectorXd still = moved_by(model, {0, 0, 0});
    const Vector3d inside(0, -0.03, 0);
    CAPTURE(c.size.transpose());
    CHECK_FALSE(clear(still, moved_by(model, c.beyond), {}));
    CHECK_FALSE(clear(still, moved_by(model, inside), {}));
    CHECK(clear(moved_by(model, inside), still, {}));  // out again
    CHECK(clear(still, moved_by(model, c.before), {}));
    CHECK(clear(still, moved_by(model, c.beside), {}));
    CHECK(clear.cuts(still, moved_by(model, inside)));
    CHECK_FALSE(clear.cuts(moved_by(model, inside), moved_by(model, 1.01 * inside)));
    CHECK_FALSE(clear.cuts(still, moved_by(model, c.before)));
  }
}

TEST_CASE("a tool that moves goes through tissue that stands still, and not around it", "[contact]") {
  Model model = test::box_model(1, 1, 1, {0.1, 0.1, 0.1}, test::soft(1e5));
  Tool plate;
  plate.shape = BoxShape{{0, 0, 0}, {0.2, 0.002, 0.2}};
  plate.path.emplace_back();
  Tool ball;
  ball.shape = SphereShape{{0, 0, 0}, 0.01};
  ball.path.emplace_back();
  model.tools = {plate, ball};
  const ContactSurface contact = make_contact_surface(model);
  const ClearWay clear(model, contact, 0);
  const VectorXd still = VectorXd::Zero(24);
  const auto way = [&](std::size_t tool, const Vector3d& from, const Vector3d& to) {
    ToolMotion motion = motion_on_paths(model.tools, 0, 0);
    const Vector3d away(5, 5, 5);
    for (ToolPlace& place : motion.from) place.pose.origin = away;
    motion.to = motion.from;
    motion.from[tool].pose.origin = from;
    motion.to[tool].pose.origin = to;
    return clear.of_moving_tools(still, still, motion);
  };
  CHECK_FALSE(way(0, {0.05, -0.1, 0.05}, {0.05, 0.2, 0.05}));
  CHECK(way(0, {0.05, -0.1, 0.05}, {0.05, -0.01, 0.05}));
  CHECK(way(0, {0.05, -0.1, 0.05}, {0.05, -0.0015, 0.05}));  // presses it by a little
  CHECK(way(0, {0.5, -0.1, 0.05}, {0.5, 0.2, 0.05}));        // beside it
  CHECK_FALSE(way(1, {0.05, -0.05, 0.05}, {0.05, 0.15, 0.05}));
  CHECK(way(1, {-0.05, -0.05, 0.05}, {-0.05, 0.15, 0.05}));
}

}  // namespace
}  // namespace fascia
