// Tools near boxes: never missed, and not found much too early.
#include "sim/tool/tool_near_box.h"

#include <catch2/catch.hpp>
#include <random>

#include "sim/tool/shape_distance.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("a tool is near a box if any point of it is within reach, and not if all are clearly beyond") {
  SceneTools scene;
  scene.ground = Ground{-0.2, {}};
  const auto add = [&](const char* name, const ToolShape& shape) {
    scene.instruments.push_back({name, shape, std::nullopt, {{}}, false});
  };
  add("ball", SphereShape{{0.02, 0, 0}, 0.03});
  add("rod", CapsuleShape{{0, 0, 0}, {0, 0.4, 0}, 0.01});
  add("box", BoxShape{{0, 0, 0}, {0.05, 0.02, 0.01}, 0.002});
  add("needle", CylinderShape{{0, 0, 0}, {0, 0.3, 0}, 0.002});
  scene.instruments.push_back(
      {"jaws", JawsShape{BoxShape{{0, 0.05, 0}, {0.01, 0.05, 0.01}, 0}, {0, 0, 1}, 40}, std::nullopt, {{}}, false});
  const Eigen::AlignedBox3d box(Vector3d(-0.1, -0.05, 0), Vector3d(0.1, 0.05, 0.3));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> near(-0.6, 0.6);
  constexpr int kGrid = 20;
  for (const Tool& tool : tools_of(scene)) {
    int decided[2] = {0, 0};
    for (int i = 0; i < 200; ++i) {
      const ToolPlace place{
          {Eigen::AngleAxisd(5 * near(random), Vector3d(near(random), near(random), 1).normalized()).toRotationMatrix(),
           Vector3d(0.4 * near(random), 0.3 * near(random), 0.15 + 0.5 * near(random))},
          0.5 + 0.8 * near(random)};
      double distance = 1e300;
      for (std::size_t piece = 0; piece < tool.piece_count(); ++piece) {
        const RigidPose pose = tool.pose_of_piece(piece, place);
        for (int k = 0; k < kGrid * kGrid * kGrid; ++k) {
          const Vector3d share = Vector3d(k % kGrid, k / kGrid % kGrid, k / kGrid / kGrid) / (kGrid - 1);
          const Vector3d x = box.min() + share.cwiseProduct(box.sizes());
          distance = std::min(distance, distance_to(tool.shape, pose.to_local(x)).distance);
        }
      }
      const double reach = 0.03 + 0.02 * near(random);
      const bool is_near = is_near_box(tool, place, box, reach);
      INFO(tool.name << ", distance " << distance << ", reach " << reach);
      if (distance <= reach) CHECK(is_near);
      if (distance > reach + box.diagonal().norm() / 8 + 0.01) CHECK_FALSE(is_near);  // 0.01: of the grid
      ++decided[is_near];
    }
    INFO(tool.name);
    CHECK(decided[0] > 10);
    CHECK(decided[1] > 10);
  }
}
