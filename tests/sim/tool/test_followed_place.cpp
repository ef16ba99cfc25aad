// The law by which tools follow a hand: at full speed where nothing is near, in small strides near tissue, and never
// through it.
#include "sim/tool/followed_place.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/rotation.h"
#include "sim/tool/shape_distance.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 0.01, kStride = kRadius / 4, kSize = 1;
constexpr double kRounding = 1e-12;

Tool tool_with(const std::variant<ToolShape, JawsShape>& shape) {
  SceneTools scene;
  scene.instruments.push_back({"tool", shape, std::nullopt, {{}}, false});
  return tools_of(scene).front();
}

Tool sphere() { return tool_with(ToolShape(SphereShape{{0, 0, 0}, kRadius})); }

// Tissue: a sheet without thickness at y = 0, which a tool that jumps would pass.
double above_sheet(const ToolPlace& place) { return std::abs(place.pose.origin.y()) - kRadius; }

ToolPlace at(double x, double y, double z = 0) { return {{Eigen::Matrix3d::Identity(), {x, y, z}}, 0}; }

}  // namespace

TEST_CASE("far from tissue a tool is where the hand wants it, in one step") {
  const ToolPlace wanted{{rotation_of({10, 80, 170}), {3, 2, 0}}, 0};
  CHECK(followed_place(sphere(), at(-3, 1), wanted, kSize, [](const ToolPlace&) { return 5.0; }) == wanted);
  CHECK(followed_place(sphere(), wanted, wanted, kSize, [](const ToolPlace&) { return -1.0; }) == wanted);
}

TEST_CASE("a jump of the hand through tissue stops before the first touch and goes on in strides") {
  const Tool tool = sphere();
  const ToolPlace wanted = at(0, -1);
  ToolPlace place = followed_place(tool, at(0, 1), wanted, kSize, above_sheet);
  CHECK(above_sheet(place) > 0);
  CHECK(above_sheet(place) < kRadius);
  int steps = 0;
  while (place.pose.origin.y() > -0.5 * kRadius) {
    const ToolPlace next = followed_place(tool, place, wanted, kSize, above_sheet);
    const double way = (next.pose.origin - place.pose.origin).norm();
    CHECK(way <= kStride + kRounding);
    CHECK(way > 0.99 * kStride);
    place = next;
    REQUIRE(++steps < 20);
  }
  INFO("and leaves it at full speed once it is a radius away");
  while (place != wanted) {
    place = followed_place(tool, place, wanted, kSize, above_sheet);
    REQUIRE(++steps < 40);
  }
  CHECK(steps > 4);
}

TEST_CASE("along tissue that is near, a tool goes in strides; beside it, at full speed") {
  const Tool tool = sphere();
  const auto way = [&](double height) {
    const ToolPlace from = at(0, height), to = at(0.1, height);
    return (followed_place(tool, from, to, kSize, above_sheet).pose.origin - from.pose.origin).norm();
  };
  CHECK(way(1.5 * kRadius) == Approx(kStride));
  CHECK(way(3 * kRadius) == Approx(0.1));
}

TEST_CASE("near tissue no point of a tool that turns or closes moves farther than a stride") {
  const CapsuleShape rod{{0, 0, 0}, {0, 0.2, 0}, kRadius};
  const Tool rods[] = {tool_with(ToolShape(rod)), tool_with(JawsShape{rod, {0, 0, 1}, 40})};
  const auto near = [](const ToolPlace&) { return 0.0; };
  const ToolPlace from{{rotation_of({20, 0, 0}), {0, 0.1, 0}}, 0}, to{{rotation_of({-30, 60, 100}), {0.3, 0, 0.1}}, 1};
  for (const Tool& tool : rods) {
    ToolPlace place = from;
    double farthest = 0, least = 1;
    int steps = 0;
    for (; place != to && steps < 100000; ++steps) {
      const ToolPlace next = followed_place(tool, place, to, kSize, near);
      double way = 0;
      for (std::size_t piece = 0; piece < tool.piece_count(); ++piece)
        for (const Vector3d& end : {Vector3d(0, -kRadius, 0), Vector3d(0, 0.2 + kRadius, 0), Vector3d(kRadius, 0.2, 0)})
          way = std::max(
              way,
              (tool.pose_of_piece(piece, next).to_scene(end) - tool.pose_of_piece(piece, place).to_scene(end)).norm());
      farthest = std::max(farthest, way);
      if (next != to) least = std::min(least, way);
      place = next;
    }
    INFO("steps " << steps << ", way in a step " << least << " to " << farthest);
    CHECK(place == to);
    CHECK(farthest <= kStride + kRounding);
    CHECK(least > 0.2 * kStride);
  }
}

TEST_CASE("a tool larger than the tissue is as slow as one of a tenth of its size") {
  const Tool plane = tool_with(ToolShape(PlaneShape{{0, 0, 0}, {0, 1, 0}}));
  CHECK(followed_radius(plane, 0.2) == Approx(0.02));
  const auto near = [](const ToolPlace&) { return 0.0; };
  CHECK(followed_place(plane, at(0, 0), at(0, 1), 0.2, near).pose.origin.y() == Approx(0.005));
  const ToolPlace turned = followed_place(plane, at(0, 0), {{rotation_of({0, 0, 90}), {0, 0, 0}}, 0}, 0.2, near);
  CHECK(way_between(plane, at(0, 0), turned, 0.2) == Approx(0.005));
}
