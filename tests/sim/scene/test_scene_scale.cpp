// A scene in another unit is the same scene at another size.
#include <algorithm>
#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/grab/build_model.h"
#include "sim/model/model.h"
#include "sim/scene/scene_scale.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Scene cube_with_all_lengths() {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  Body& body = scene.bodies[0];
  body.transform = {2, {0, 30, 0}, {0.1, 0.2, 0.3}};
  PrescribedMotion motion;
  motion.select = LowestSelection{0.02};
  motion.translate = {0.01, 0, 0.02};
  motion.axis = Vector3d::UnitY();
  motion.angle_deg = 40;
  motion.center = {0.1, 0.2, 0.3};
  motion.duration = 1;
  body.fixed.clear();
  body.prescribed = {motion};
  body.initial_velocity = Vector3d(0, 0.5, 0);
  const Model model = build_model(scene);
  ScriptedGrab led, pushed;
  led.where = pushed.where = *std::max_element(model.rest_positions.begin(), model.rest_positions.end(),
                                               [](const Vector3d& a, const Vector3d& b) { return a.y() < b.y(); });
  led.radius = 0.05;
  led.path = {{0.5, {0, 0.01, 0}}, {1, {0.01, 0, 0}}};
  pushed.push = 0.02;
  scene.grabs = {led, pushed};
  scene.display.section = SectionPlane{{0, 0, 1}, 0.3};
  scene.camera = CameraSettings{};
  scene.camera_motion.keys.resize(1);
  scene.camera_motion.keys[0].eye = Vector3d(0, 1, 2);
  return scene;
}

}  // namespace

TEST_CASE("every length of a scene is scaled: bodies, motions, grabs, velocities, the section") {
  const Scene before = cube_with_all_lengths();
  Scene after = before;
  constexpr double kFactor = 1e-3;
  scale_lengths(after, kFactor);
  const Model large = build_model(before), small = build_model(after);
  REQUIRE(small.rest_positions.size() == large.rest_positions.size());
  // Some ten operations on numbers of 1 m and 1 m/s, each with a rounding of 1e-16.
  const auto close = [&](const Vector3d& a, const Vector3d& b) { return (a - kFactor * b).norm() < 1e-14 * kFactor; };
  bool same = true;
  for (std::size_t v = 0; v < large.rest_positions.size(); ++v)
    same &= close(small.rest_positions[v], large.rest_positions[v]) &&
            close(small.initial_velocity[v], large.initial_velocity[v]);
  CHECK(same);
  REQUIRE(small.grabs.size() == 2);
  REQUIRE(small.motions.size() == 1);
  for (const double time : {0.3, 0.8, 2.0}) {
    CAPTURE(time);
    const auto moved = [&](const Model& model) {
      return model.motions[0].position(0, model.rest_positions[model.motions[0].vertices[0]], time);
    };
    CHECK(close(moved(small), moved(large)));
    for (std::size_t h = 0; h < 2; ++h) {
      CHECK(small.grabs[h].grip.size() == large.grabs[h].grip.size());
      CHECK(close(small.grabs[h].displacement(time), large.grabs[h].displacement(time)));
    }
  }
  CHECK(after.display.section->offset == Approx(3e-4));
  CHECK(after.camera->eye == kFactor * before.camera->eye);
  CHECK(*after.camera_motion.keys[0].eye == kFactor * Vector3d(0, 1, 2));
  CHECK(after.gravity == before.gravity);
}

TEST_CASE("lengths in files are not scaled, and then nothing is") {
  Scene scene = cube_with_all_lengths();
  scene.bodies[0].initial_velocity = std::string("velocity.csv");
  const Scene before = scene;
  CHECK_THROWS_WITH(scale_lengths(scene, 0.001),
                    Catch::Contains("bodies[0].initial_velocity") && Catch::Contains("velocity.csv"));
  CHECK(scene == before);
}
