// A camera that moves by itself: through its keys, monotone between them, around the target; and a turntable.
#include "app/headless/camera_path.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "app/headless/render_camera.h"
#include "base/error.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

const CameraSettings kFront{{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 40};

CameraKey key(double time) {
  CameraKey result;
  result.time = time;
  return result;
}

bool same_place(const Vector3d& a, const Vector3d& b) { return (a - b).norm() < 1e-12 * (1 + b.norm()); }

}  // namespace

TEST_CASE("a camera path is at its keys at their times, and at the ends before and after", "[camera_path]") {
  CameraMotion motion;
  motion.keys = {key(1), key(2), key(4), key(5)};
  motion.keys[1].orbit_deg = 90;
  motion.keys[1].zoom = 2;
  motion.keys[2].eye = Vector3d(0, 3, -4);
  motion.keys[3].target = Vector3d(1, 1, 1);
  motion.keys[3].elevation_deg = 0;
  motion.keys[3].fov_deg = 20;
  motion.smooth = GENERATE(true, false);
  const CameraPath path(motion, kFront, "s.json");
  CHECK(same_place(path.at(0).eye, {0, 0, 2}));
  CHECK(same_place(path.at(1).eye, {0, 0, 2}));
  CHECK(same_place(path.at(2).eye, {1, 0, 0}));
  CHECK(same_place(path.at(4).eye, {0, 3, -4}));
  CHECK(same_place(path.at(5).eye, Vector3d(1, 1, 1) + Vector3d(0, 0, -5)));
  CHECK(same_place(path.at(9).eye, path.at(5).eye));
  CHECK(path.at(4).fov_deg == 40);
  CHECK(path.at(5).fov_deg == 20);
  CHECK(path.end() == 5);
  const CameraSettings between = path.at(4.5);
  CHECK(between.fov_deg == Approx(motion.smooth ? 32.5 : 30));  // smooth: at rest in the key before, where it turns
  CHECK(between.target.x() == Approx(motion.smooth ? 0.375 : 0.5));
}

TEST_CASE("an orbit keeps its distance and turns to the right at an even speed", "[camera_path]") {
  CameraMotion motion;
  motion.keys = {key(0), key(4)};
  motion.keys[1].orbit_deg = 720;
  const CameraPath path(motion, kFront, "s.json");
  for (const double time : {0.25, 1.0, 1.5, 3.75}) {
    const double angle = std::acos(-1.0) * time;
    CAPTURE(time);
    CHECK(same_place(path.at(time).eye, {2 * std::sin(angle), 0, 2 * std::cos(angle)}));
  }
}

TEST_CASE("between two keys the camera never leaves their values, and rests between equal ones", "[camera_path]") {
  CameraMotion motion;
  motion.keys = {key(0), key(1), key(1.5), key(3), key(4)};
  const double turns[] = {0, 90, 90, 10, 300};
  for (std::size_t k = 0; k < 5; ++k) motion.keys[k].orbit_deg = turns[k];
  const CameraPath path(motion, kFront, "s.json");
  const auto angle = [&](double time) {
    const Vector3d eye = path.at(time).eye;
    return std::atan2(eye.x(), eye.z()) * 180 / std::acos(-1.0);
  };
  double fastest = 0;
  for (double time = 0; time < 3; time += 0.01) {
    CAPTURE(time, angle(time));
    CHECK(angle(time) > -1e-9);
    CHECK(angle(time) < 90 + 1e-9);
    fastest = std::max(fastest, std::abs(angle(time + 0.01) - angle(time)) / 0.01);
  }
  CHECK(fastest < 3 * 90);  // of a monotone cubic at most thrice the mean slope
  CHECK(angle(1.2) == Approx(90));
  CHECK(path.at(3.99).eye != path.at(4).eye);
}

TEST_CASE("an eye takes the shorter turn, and the view never becomes vertical", "[camera_path]") {
  CameraMotion motion;
  motion.smooth = false;
  motion.keys = {key(0), key(1), key(2)};
  motion.keys[0].orbit_deg = 170;
  motion.keys[1].eye = Vector3d(2 * std::sin(-3.0), 0, 2 * std::cos(-3.0));  // at -172 degrees
  motion.keys[2].eye = Vector3d(0, 5, 0);
  const CameraPath path(motion, kFront, "s.json");
  CHECK(path.at(0.5).eye.z() < -1.9);
  const Vector3d above = path.at(2).eye;
  CHECK(above.norm() == Approx(5));
  CHECK(above.y() == Approx(5 * std::sin(89 * std::acos(-1.0) / 180)));
}

TEST_CASE("an eye at its target names its key", "[camera_path]") {
  CameraMotion motion;
  motion.keys = {key(0), key(1)};
  motion.keys[1].eye = Vector3d(0, 0, 0);
  CHECK_THROWS_WITH(CameraPath(motion, kFront, "s.json"),
                    "s.json: camera.keys[1]: eye and target are the same point; expected two different points");
}

TEST_CASE("a turn moves the eye about the target and up", "[camera_path]") {
  const CameraSettings camera{{1, 2, 3}, {1, 1, 1}, {0, 1, 0}, 30};
  CHECK(same_place(turned(camera, 90).eye, {3, 2, 1}));
  CHECK(same_place(turned(camera, 360).eye, camera.eye));
  CHECK(turned(camera, 45).target == camera.target);
}

TEST_CASE("a turntable is seconds for a turn or degrees in all", "[camera_path]") {
  CHECK(parse_turntable("8s").seconds == 8.0);
  CHECK(!parse_turntable("-90deg").seconds);
  CHECK(parse_turntable("-90deg").degrees == -90);
  for (const char* wrong : {"", "8", "s", "0s", "-3s", "8 s", "1e9s", "0deg", "360", "nans", "8min"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(parse_turntable(wrong),
                      Catch::StartsWith("--turntable: is " + std::string(wrong) + "; expected seconds of the video"));
  }
}
