// Covers: rigid_pose, tool_motion
#include "sim/tool/tool.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "base/rotation.h"
#include "sim/tool/shape_distance.h"
#include "sim/tool/tool_motion.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

Tool only(const Instrument& instrument) {
  SceneTools tools;
  tools.instruments.push_back(instrument);
  return tools_of(tools).front();
}

TEST_CASE("an instrument follows the keys of its path", "[tool]") {
  Instrument instrument;
  instrument.shape = ToolShape(SphereShape{{0, 0, 0}, 0.01});
  instrument.path = {{1, {0, 0, 0}, {0, 0, 0}}, {3, {0.2, 0, 0}, {0, 0, 720}}};
  const Tool tool = only(instrument);
  CHECK(tool.place(0).pose.origin == Vector3d(0, 0, 0));
  CHECK(tool.place(9).pose.origin == Vector3d(0.2, 0, 0));
  CHECK(tool.place(1.5).pose.origin.x() == Approx(0.05));
  CHECK(tool.place(1.25).pose.axes.col(0).isApprox(Vector3d(0, 1, 0), 1e-12));  // 90 of two whole turns
  instrument.smooth = true;
  CHECK(only(instrument).place(1.5).pose.origin.x() == Approx(0.2 * (3 - 2 * 0.25) * 0.0625));
  CHECK(only(instrument).place(2).pose.origin.x() == Approx(0.1));
  CHECK(only(instrument).end() == 3);
}

TEST_CASE("a tool without a path stays at the origin", "[tool]") {
  const Tool tool;
  CHECK(tool.place(1) == ToolPlace{});
  CHECK(tool.end() == 0);
}

TEST_CASE("rotations are about x, then y, then z", "[tool]") {
  CHECK((rotation_of({90, 0, 0}) * Vector3d(0, 1, 0)).isApprox(Vector3d(0, 0, 1), 1e-12));
  CHECK((rotation_of({90, 90, 0}) * Vector3d(0, 1, 0)).isApprox(Vector3d(1, 0, 0), 1e-12));
  CHECK((rotation_of({90, 90, 90}) * Vector3d(0, 1, 0)).isApprox(Vector3d(0, 1, 0), 1e-12));
}

TEST_CASE("jaws are mirror images that close on the plane between them", "[tool]") {
  Instrument instrument;
  instrument.shape = JawsShape{BoxShape{{0.03, 0.002, 0}, {0.02, 0.002, 0.004}, 0}, {0, 0, 1}, 40};
  instrument.path = {{0, {0, 0, 0}, {0, 0, 0}, 0}, {1, {0, 0, 0}, {0, 0, 0}, 1}};
  const Tool tool = only(instrument);
  REQUIRE(tool.piece_count() == 2);
  const auto distance = [&](std::size_t piece, double time, const Vector3d& x) {
    return distance_to(tool.shape, tool.pose_of_piece(piece, tool.place(time)).to_local(x)).distance;
  };
  // Closed: both touch the plane y = 0, from above and from below.
  CHECK(distance(0, 1, {0.03, 0, 0}) == Approx(0).margin(1e-12));
  CHECK(distance(1, 1, {0.03, 0, 0}) == Approx(0).margin(1e-12));
  CHECK(distance(0, 1, {0.03, 0.002, 0}) < 0);
  CHECK(distance(1, 1, {0.03, -0.002, 0}) < 0);
  // Open: each has turned by 20 degrees, away from the other.
  const Vector3d upper = rotation_of({0, 0, 20}) * Vector3d(0.03, 0.002, 0),
                 lower = upper.cwiseProduct(Vector3d(1, -1, 1));
  CHECK(distance(0, 0, upper) == Approx(-0.002));
  CHECK(distance(1, 0, lower) == Approx(-0.002));
  CHECK(distance(0, 0, lower) > 0.01);
  for (const Vector3d& x : {Vector3d(0.01, 0.02, 0.003), Vector3d(0.05, -0.01, 0)})
    CHECK(distance(0, 0.3, x) == Approx(distance(1, 0.3, x.cwiseProduct(Vector3d(1, -1, 1)))));
}

TEST_CASE("a part of a motion begins and ends on the way", "[tool]") {
  Instrument instrument;
  instrument.shape = ToolShape(SphereShape{{0, 0, 0}, 0.01});
  instrument.path = {{0, {0, 0, 0}, {0, 0, 0}}, {1, {1, 0, 0}, {0, 90, 0}}};
  const ToolMotion motion = motion_on_paths({only(instrument)}, 0, 1), part = motion.part(0.25, 0.5);
  CHECK(part.from[0].pose.origin.x() == Approx(0.25));
  CHECK(part.to[0].pose.origin.x() == Approx(0.5));
  CHECK(part.to[0].pose.axes.isApprox(rotation_of({0, 45, 0}), 1e-12));
  CHECK(motion.part(0, 1) == motion);
}

}  // namespace
}  // namespace fascia
