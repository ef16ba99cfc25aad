// Positions of prescribed vertices over time, and the vertices that a scene prescribes.
#include <Eigen/Geometry>
#include <numbers>

#include "sim/grab/build_model.h"
#include "sim/model/model.h"
#include "sim/model/prescribed_motion.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

constexpr double kRounding = 1e-15;  // a few operations on numbers of size 1 to 4

Model model_with(const std::string& motions, const std::string& csv = "") {
  const SceneFile file(scene_text("\"prescribed\": [" + motions + "]"));
  std::filesystem::copy_file(test_dir() / "reference/01_cantilever_small/mesh.msh", file / "m.msh");
  write_file(file / "t.csv", csv);
  return build_model(file.open());
}

std::string error_with(const std::string& motions, const std::string& csv = "") {
  const SceneFile file(scene_text("\"prescribed\": [" + motions + "]"));
  std::filesystem::copy_file(test_dir() / "reference/01_cantilever_small/mesh.msh", file / "m.msh");
  write_file(file / "t.csv", csv);
  return file.error_of([&] { build_model(file.open()); });
}

}  // namespace

TEST_CASE("a translation is straight, linear in time, and constant before and after") {
  Motion motion;
  motion.translate = {4, 0, -2};
  motion.start = 1;
  motion.duration = 2;
  const Vector3d rest(1, 1, 1);
  CHECK(motion.position(0, rest, 0) == rest);
  CHECK(motion.position(0, rest, 1) == rest);
  CHECK(motion.position(0, rest, 1.5) == Vector3d(2, 1, 0.5));
  CHECK(motion.position(0, rest, 2) == Vector3d(3, 1, 0));
  CHECK(motion.position(0, rest, 3) == Vector3d(5, 1, -1));
  CHECK(motion.position(0, rest, 100) == Vector3d(5, 1, -1));
}

TEST_CASE("a motion without duration is complete at once") {
  Motion motion;
  motion.translate = {1, 0, 0};
  motion.start = 0.5;
  CHECK(motion.position(0, {0, 0, 0}, 0.49) == Vector3d(0, 0, 0));
  CHECK(motion.position(0, {0, 0, 0}, 0.5) == Vector3d(1, 0, 0));
}

TEST_CASE("a rotation follows the arc about its center, with an axis of any length") {
  Motion motion;
  motion.axis = {0, 0, 10};
  motion.center = {1, 0, 0};
  motion.angle = std::numbers::pi;
  motion.duration = 1;
  const Vector3d rest(3, 0, 5);
  CHECK((motion.position(0, rest, 0.5) - Vector3d(1, 2, 5)).norm() < kRounding);
  CHECK((motion.position(0, rest, 1) - Vector3d(-1, 0, 5)).norm() < kRounding);
  for (const double t : {0.1, 0.3, 0.77}) {
    CAPTURE(t);
    const Vector3d at = motion.position(0, rest, t) - motion.center;
    CHECK(at.head<2>().norm() == Approx(2).epsilon(1e-15));
    CHECK(std::atan2(at.y(), at.x()) == Approx(t * std::numbers::pi).epsilon(1e-14));
  }
}

TEST_CASE("rotations beyond 180 degrees are made in full") {
  Motion motion;
  motion.axis = {0, 0, 1};
  motion.angle = 2 * std::numbers::pi;
  motion.duration = 1;
  CHECK((motion.position(0, {1, 0, 0}, 0.5) - Vector3d(-1, 0, 0)).norm() < kRounding);
}

TEST_CASE("a scale is about the center, and combines with the other motions") {
  Motion motion;
  motion.scale = 3;
  motion.center = {1, 0, 0};
  motion.duration = 1;
  CHECK(motion.position(0, {2, 0, 0}, 0.5) == Vector3d(3, 0, 0));
  CHECK(motion.position(0, {2, 0, 0}, 1) == Vector3d(4, 0, 0));
  motion.axis = {0, 0, 1};
  motion.angle = std::numbers::pi / 2;
  motion.translate = {0, 0, 8};
  CHECK((motion.position(0, {2, 0, 0}, 1) - Vector3d(1, 3, 8)).norm() < kRounding);
}

TEST_CASE("targets are reached to the last bit, on a straight path") {
  Motion motion;
  motion.targets = {{0.1, 0.2, 0.3}, {4, 5, 6}};
  motion.duration = 3;
  CHECK(motion.position(0, {0.7, 0.7, 0.7}, 3) == Vector3d(0.1, 0.2, 0.3));
  CHECK(motion.position(0, {0.7, 0.7, 0.7}, 0) == Vector3d(0.7, 0.7, 0.7));
  CHECK((motion.position(1, {2, 3, 4}, 1.5) - Vector3d(3, 4, 5)).norm() < kRounding);
}

TEST_CASE("a scene's degrees become radians and its selection vertices") {
  const Model model = model_with(R"({"select": {"box": [[0.39, -1, -1], [0.41, 1, 1]]}, "start": 1, "duration": 2,
      "rotate_deg": {"axis": [1, 0, 0], "angle": 90, "center": [0.4, 0, 0]}, "scale": 1.5, "translate": [0.1, 0, 0]})");
  REQUIRE(model.motions.size() == 1);
  const Motion& motion = model.motions[0];
  CHECK(motion.angle == Approx(std::numbers::pi / 2).epsilon(1e-15));
  CHECK(motion.center == Vector3d(0.4, 0, 0));
  CHECK(motion.scale == 1.5);
  CHECK(motion.start == 1);
  CHECK(motion.duration == 2);
  REQUIRE(!motion.vertices.empty());
  for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
    const Vector3d rest = model.rest_positions[motion.vertices[k]];
    CHECK(rest.x() > 0.39);
    const Vector3d expected(0.4 + 1.5 * (rest.x() - 0.4) + 0.1, -1.5 * rest.z(), 1.5 * rest.y());
    CHECK((motion.position(k, rest, 3) - expected).norm() < kRounding);
  }
}

TEST_CASE("prescribed vertices are placed in a state, and the others left") {
  const Model model = model_with(R"({"select": {"vertices": [3, 4]}, "translate": [1, 0, 0], "duration": 2})");
  std::vector<Vector3d> displacement(model.rest_positions.size(), Vector3d(7, 8, 9));
  place_prescribed(model, 0.5, displacement);
  CHECK((displacement[3] - Vector3d(0.25, 0, 0)).norm() < kRounding);
  CHECK((displacement[4] - Vector3d(0.25, 0, 0)).norm() < kRounding);
  CHECK(displacement[5] == Vector3d(7, 8, 9));
}

TEST_CASE("targets move the vertices of their table, or the selected ones of them") {
  const std::string csv = "index,x,y,z\n7,1,1,1\n4,2,2,2\n5,3,3,3\n";
  const Model all = model_with(R"({"targets": "t.csv", "duration": 1})", csv);
  CHECK(all.motions[0].vertices == std::vector<std::uint32_t>{4, 5, 7});
  CHECK(all.motions[0].targets == std::vector<Vector3d>{{2, 2, 2}, {3, 3, 3}, {1, 1, 1}});
  const Model some = model_with(R"({"select": {"vertices": [7, 4]}, "targets": "t.csv"})", csv);
  CHECK(some.motions[0].vertices == std::vector<std::uint32_t>{4, 7});
  CHECK(some.motions[0].targets == std::vector<Vector3d>{{2, 2, 2}, {1, 1, 1}});
}

TEST_CASE("invalid motions") {
  CHECK(error_with(R"({"select": {"vertices": [4, 6]}, "targets": "t.csv"})", "4,0,0,0\n5,0,0,0\n") ==
        "s.json: bodies[0].prescribed[0].targets: t.csv: misses vertex 6, which s.json: bodies[0].prescribed[0].select "
        "selects; expected a line for each of the 2 selected vertices");
  CHECK(error_with(R"({"targets": "t.csv"})", "4,0,0,0\n613,0,0,0\n") ==
        "s.json: bodies[0].prescribed[0].targets: t.csv:2: vertex 613 does not exist; expected 0 to 612");
  CHECK_THAT(error_with(R"({"targets": "nowhere.csv"})"),
             Catch::Contains("s.json: bodies[0].prescribed[0].targets: nowhere.csv: no such file; looked in "));
  CHECK(error_with(R"({"select": {"vertices": [4]}}, {"select": {"vertices": [3, 4]}, "start": 1})") ==
        "s.json: bodies[0].prescribed[1]: moves vertex 4, as prescribed[0] does; expected each vertex in one motion");
}
