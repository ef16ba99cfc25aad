// Ground, obstacles and instruments of scenes: reading, writing, and the text of an option.
// Covers: write_tools, scale_tools, instrument_text, base/json/json_option, base/json/json_write
#include "sim/scene/tools/read_tools.h"

#include "sim/scene/tools/instrument_text.h"
#include "sim/scene/tools/scale_tools.h"
#include "tests/sim/scene/scene_test.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::scene_text;
using test::SceneFile;

const std::string kTools = R"("contact": {"friction": 0.4, "thickness": 0.002},
  "ground": {"height": -0.1, "friction": 0.6},
  "obstacles": [{"name": "table", "shape": {"box": {"half_size": [0.5, 0.02, 0.5], "round": 0.01}},
                 "position": [0, -0.2, 0], "rotate_deg": [0, 45, 0]}],
  "instruments": [{"name": "probe", "shape": {"capsule": {"from": [0, 0, 0], "to": [0, 0.1, 0], "radius": 0.004}},
                   "friction": 0.2, "interpolate": "smooth",
                   "path": [{"time": 0, "position": [0, 0.2, 0]}, {"time": 1.5, "position": [0, 0.1, 0],
                            "rotate_deg": [0, 0, 10]}, {"time": 2}]},
                  {"name": "forceps", "jaws": {"shape": {"cylinder": {"from": [0, 0, 0], "to": [0.1, 0, 0],
                   "radius": 0.003}}, "axis": [0, 0, 1], "open_deg": 30}, "path": [{"time": 0, "grip": 0.5}]}])";

TEST_CASE("the tools of a scene are read, and written as they were") {
  const SceneFile file(scene_text("", kTools));
  const SceneTools tools = file.open().tools;
  CHECK(tools.contact.friction == 0.4);
  CHECK(tools.contact.thickness == 0.002);
  CHECK(tools.ground->height == -0.1);
  CHECK(std::get<BoxShape>(tools.obstacles.at(0).shape).half_size == Vector3d(0.5, 0.02, 0.5));
  const Instrument& probe = tools.instruments.at(0);
  CHECK(probe.smooth);
  CHECK(probe.path.size() == 3);
  CHECK(probe.path[2].position == Vector3d(0, 0.1, 0));  // as in the key before
  CHECK(probe.path[2].rotate_deg == Vector3d(0, 0, 10));
  CHECK(std::get<JawsShape>(tools.instruments.at(1).shape).open_deg == 30);
  CHECK(tools.instruments[1].path[0].grip == 0.5);

  const SceneFile copy(scene_to_json(file.open(), file.path().parent_path()));
  CHECK(copy.open().tools == tools);
  CHECK(SceneFile(scene_text()).open().tools.empty());
}

TEST_CASE("a tool may be a mesh, whose path is kept") {
  const SceneFile file(
      scene_text("", R"("obstacles": [{"name": "rest", "shape": {"mesh": {"file": "rest.obj", "scale": 0.01}}}])"));
  SceneTools tools = file.open().tools;
  const auto mesh = [&] { return std::get<MeshShape>(tools.obstacles.at(0).shape); };
  CHECK(mesh().file == "rest.obj");
  CHECK(mesh().scale == 0.01);
  CHECK(SceneFile(scene_to_json(file.open(), file.path().parent_path())).open().tools == tools);
  scale_lengths(tools, 10);
  CHECK(mesh().scale == 0.1);
  CHECK(instrument_document("name=a;shape=mesh;file=b.obj;scale=0.1")["shape"] ==
        nlohmann::json::parse(R"({"mesh": {"file": "b.obj", "scale": 0.1}})"));
  CHECK(SceneFile(scene_text("", R"("obstacles": [{"name": "rest", "shape": {"mesh": {}}}])"))
            .open_error()
            .find("s.json: obstacles[0].shape.mesh") == 0);
}

TEST_CASE("a scene of another size has its tools at that size") {
  SceneTools tools = SceneFile(scene_text("", kTools)).open().tools;
  scale_lengths(tools, 0.5);
  CHECK(tools.contact.thickness == 0.001);
  CHECK(tools.contact.friction == 0.4);
  CHECK(tools.ground->height == -0.05);
  const Obstacle& table = tools.obstacles.at(0);
  CHECK(table.position == Vector3d(0, -0.1, 0));
  CHECK(table.rotate_deg == Vector3d(0, 45, 0));
  CHECK(std::get<BoxShape>(table.shape) == BoxShape{{0, 0, 0}, {0.25, 0.01, 0.25}, 0.005});
  CHECK(std::get<CapsuleShape>(std::get<ToolShape>(tools.instruments.at(0).shape)) ==
        CapsuleShape{{0, 0, 0}, {0, 0.05, 0}, 0.002});
  CHECK(tools.instruments[0].path[0].position == Vector3d(0, 0.1, 0));
  CHECK(tools.instruments[0].path[1].time == 1.5);
  CHECK(std::get<CylinderShape>(std::get<JawsShape>(tools.instruments.at(1).shape).shape) ==
        CylinderShape{{0, 0, 0}, {0.05, 0, 0}, 0.0015});
}

TEST_CASE("bodies touch each other where a scene speaks of contact, and themselves where it asks for that") {
  const auto contact = [](const std::string& top) { return SceneFile(scene_text("", top)).open().tools.contact; };
  CHECK_FALSE(contact("").bodies);
  CHECK(contact(R"("contact": {})").bodies);
  CHECK_FALSE(contact(R"("contact": {})").self);
  CHECK_FALSE(contact(R"("contact": {"bodies": false})").bodies);
  CHECK(contact(R"("contact": {"self": true})").self);
}

TEST_CASE("values of tools may be overridden, and instruments added") {
  const SceneFile file(scene_text("", kTools));
  const Scene scene =
      file.open({"ground.friction=0.1", "instruments[0].path[0].position=[1,2,3]",
                 "--instrument name=ball;shape=sphere;radius=0.01;from=0,1,0;to=0,0.5,0;start=1;duration=2"});
  CHECK(*scene.tools.ground->friction == 0.1);
  CHECK(scene.tools.instruments[0].path[0].position == Vector3d(1, 2, 3));
  const Instrument& ball = scene.tools.instruments.at(2);
  CHECK(ball.name == "ball");
  CHECK(std::get<SphereShape>(std::get<ToolShape>(ball.shape)).radius == 0.01);
  REQUIRE(ball.path.size() == 2);
  CHECK(ball.path[0].time == 1);
  CHECK(ball.path[0].position == Vector3d(0, 1, 0));
  CHECK(ball.path[1].time == 3);
  CHECK(ball.path[1].position == Vector3d(0, 0.5, 0));
}

TEST_CASE("an instrument's text may stand still, and state a capsule by its length") {
  CHECK(instrument_document("name=a;shape=capsule;radius=0.01;length=0.2;from=1,0,0") ==
        nlohmann::json::parse(R"({"name": "a", "shape": {"capsule": {"from": [0, 0, 0], "to": [0, 0.2, 0],
          "radius": 0.01}}, "path": [{"time": 0, "position": [1, 0, 0]}]})"));
  CHECK(instrument_document("name=a;shape=sphere;radius=1;to=1,0,0")["path"] ==
        nlohmann::json::parse(R"([{"time": 0, "position": [1, 0, 0]}])"));
  CHECK_THROWS_WITH(instrument_document("name=a;oops"), Catch::StartsWith("--instrument: oops is not KEY=VALUE"));
}

TEST_CASE("mistakes in tools are errors of one line that say what was expected") {
  const auto error = [](const std::string& top) { return SceneFile(scene_text("", top)).open_error(); };
  const auto instrument = [&](const std::string& keys) { return error("\"instruments\": [{" + keys + "}]"); };
  CHECK(error(R"("ground": {"hight": 0})").find("s.json: ground.hight: unknown key \"hight\", perhaps \"height\"") ==
        0);
  CHECK(error(R"("ground": {"friction": -1})").find("s.json: ground.friction: is -1; expected 0 to 10") == 0);
  CHECK(instrument(R"("name": "p")").find("s.json: instruments[0]: has no shape; expected one of shape and jaws") == 0);
  CHECK(instrument(R"("name": "p", "shape": {})").find("instruments[0].shape: is empty; expected one of sphere") !=
        std::string::npos);
  CHECK(instrument(R"("name": "p", "shape": {"sphere": {"radius": 0}})")
            .find("instruments[0].shape.sphere.radius: is 0") != std::string::npos);
  CHECK(instrument(R"("name": "p", "shape": {"sphere": {"radius": 1}}, "path": [{"time": 1}, {"time": 1}])")
            .find("instruments[0].path[1]: time is 1.0; expected a later time than that of the key before") !=
        std::string::npos);
  CHECK(instrument(R"("name": "p", "shape": {"sphere": {"radius": 1}}, "path": [{"time": 1, "grip": 1}])")
            .find("path[0].grip: has no jaws to close") != std::string::npos);
  CHECK(instrument(R"("name": "ground", "shape": {"sphere": {"radius": 1}}}, {"name": "ground",
                     "shape": {"sphere": {"radius": 1}})")
            .find("instruments[1]: is the second one called \"ground\"") != std::string::npos);
  CHECK(error(R"("contact": {"self": 1})").find("s.json: contact.self: is 1; expected") == 0);
}

}  // namespace
}  // namespace fascia
