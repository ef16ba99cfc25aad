// Distances of tools from tissue: never more than the true ones, and less by the size of a ball at most.
#include "sim/contact/tissue/tissue_cover.h"

#include <catch2/catch.hpp>
#include <random>

#include "sim/grab/build_model.h"
#include "sim/tool/shape_distance.h"
#include "tests/support/support.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

// Of the shape from a triangle, over a fine grid of its points.
double distance_of(const Tool& tool, const ToolPlace& place, const std::array<Vector3d, 3>& face) {
  constexpr int kParts = 24;
  double nearest = 1e300;
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece) {
    const RigidPose pose = tool.pose_of_piece(piece, place);
    for (int i = 0; i <= kParts; ++i)
      for (int j = 0; i + j <= kParts; ++j) {
        const Vector3d x = face[0] + (face[1] - face[0]) * i / kParts + (face[2] - face[0]) * j / kParts;
        nearest = std::min(nearest, distance_to(tool.shape, pose.to_local(x)).distance);
      }
  }
  return nearest;
}

}  // namespace

TEST_CASE("the clearance is a lower bound of the distance to the surface, also where the tissue has moved") {
  Model model;
  model.rest_positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  model.tets = {{0, 1, 2, 3}};
  const double radius = GENERATE(0.2, 0.02);
  TissueCover cover(model, radius);
  CHECK(cover.size() == Approx(0.1 * std::sqrt(3)));
  std::vector<Vector3d> positions = model.rest_positions;
  for (Vector3d& x : positions) x += Vector3d(0.3, 0, 0);
  cover.follow(positions);

  SceneTools scene;
  scene.instruments.push_back(
      {"rod", ToolShape(CapsuleShape{{0, 0, 0}, {0, 0.2, 0}, 0.01}), std::nullopt, {{}}, false});
  scene.instruments.push_back(
      {"jaws", JawsShape{BoxShape{{0, 0.05, 0}, {0.01, 0.05, 0.01}, 0}, {0, 0, 1}, 40}, std::nullopt, {{}}, false});
  scene.instruments.push_back({"plate", ToolShape(PlaneShape{{0, 0, 0}, {0, 1, 0}}), std::nullopt, {{}}, false});
  const std::size_t faces[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> near(-0.3, 0.3);
  for (const Tool& tool : tools_of(scene))
    for (int i = 0; i < 60; ++i) {
      const ToolPlace place{{Eigen::AngleAxisd(10 * near(random), Vector3d(near(random), near(random), 1).normalized())
                                 .toRotationMatrix(),
                             Vector3d(0.3 + near(random), near(random), near(random))},
                            0.5 + near(random)};
      double distance = 1e300;
      for (const auto& f : faces)
        distance = std::min(distance, distance_of(tool, place, {positions[f[0]], positions[f[1]], positions[f[2]]}));
      const double clearance = cover.clearance(tool, place);
      INFO(tool.name << ", distance " << distance << ", clearance " << clearance);
      CHECK(clearance <= distance + 1e-9);
      constexpr double kWhole = 0.0817;  // of a ball around the largest face
      if (distance < 2 * finest_radius(tool.shape)) CHECK(clearance >= distance - std::min(radius, kWhole) - 1e-3);
    }
}

TEST_CASE("tissue at rest is met by what moves near it, as far as it moves, and not by what is still") {
  Model model;
  model.rest_positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  model.tets = {{0, 1, 2, 3}};
  model.contact.thickness = 0.002;
  const TissueCover cover(model, 0.003);
  SceneTools scene;
  scene.instruments.push_back({"ball", ToolShape(SphereShape{{0, 0, 0}, 0.02}), std::nullopt, {{}}, false});
  scene.instruments.push_back({"plate", ToolShape(PlaneShape{{0, 0, 0}, {0, 1, 0}}), std::nullopt, {{}}, false});
  const std::vector<Tool> tools = tools_of(scene);
  const auto at = [](double x, double y) { return ToolPlace{{Eigen::Matrix3d::Identity(), {x, y, 0}}, 0}; };
  CHECK_FALSE(cover.is_met_by(tools[0], at(0.119, 0), at(0.119, 0)));  // it touches, and rests
  CHECK(cover.is_met_by(tools[0], at(0.119, 0), at(0.1191, 0)));
  CHECK_FALSE(cover.is_met_by(tools[0], at(0.2, 0), at(0.199, 0)));
  CHECK_FALSE(cover.is_met_by(tools[0], at(0.2, 0), at(0.2, 0.01)));
  CHECK(cover.is_met_by(tools[0], at(0.2, 0), at(0.12, 0)));  // within the step
  CHECK_FALSE(cover.is_met_by(tools[1], at(0, -0.05), at(0, -0.049)));
  CHECK_FALSE(cover.is_met_by(tools[1], at(0, -0.03), at(0, -0.025)));
  CHECK(cover.is_met_by(tools[1], at(0, -0.02), at(0, 0.01)));
}
