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
                   "radius": 0.003, "round": 0.001}}, "axis": [0, 0, 1], "open_deg": 30}, "path": [{"time": 0, "grip": 0.5}]}])";

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
  CHECK(instrument_document("name=a;shape=mesh;file=b.obj;scale=0.1;from=0,0,0")["shape"] ==
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
        CylinderShape{{0, 0, 0}, {0.05, 0, 0}, 0.0015, 0.0005});
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
  CHECK(instrument_document("name=a;shape=sphere;radius=1;to=1,0,0;duration=2")["path"] ==
        nlohmann::json::parse(R"([{"time": 0}, {"time": 2, "position": [1, 0, 0]}])"));
}

// Each with the message that it must begin with, after "--instrument: ".
TEST_CASE("mistakes in an instrument's text are errors that name the key") {
  const auto error = [](const std::string& text) {
    return SceneFile(scene_text()).open_error({"--instrument " + text});
  };
  const std::string ball = "name=a;shape=sphere;radius=0.01;", rod = "name=a;shape=capsule;radius=0.01;";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"name=a;oops", "oops is not KEY=VALUE; expected such as name=probe"},
      {"name=a;name=b", "name is given twice; expected each key once"},
      {ball + "lenght=1", "lenght: unknown key \"lenght\", perhaps \"length\"; expected one of name, shape,"},
      {"shape=sphere;radius=1;from=0,0,0", "instruments[0].name: is missing"},
      {"name=;shape=sphere;radius=1;from=0,0,0", "has an empty name"},
      {"name=a", "has no shape; expected one of shape and jaws"},
      {"name=a;shape=spere;radius=1",
       "shape: there is no shape \"spere\", perhaps \"sphere\"; expected one of sphere,"},
      {"name=a;shape=sphere", "radius: is missing; expected it beside shape=sphere"},
      {"name=a;shape=box", "half_size: is missing; expected it beside shape=box"},
      {"name=a;shape=plane", "normal: is missing; expected it beside shape=plane"},
      {"name=a;shape=mesh", "file: is missing; expected it beside shape=mesh"},
      {"name=a;shape=mesh;file=;from=0,0,0",
       "instruments[0].shape.mesh.file: is \"\"; expected the path of a closed surface"},
      {rod, "length: is missing; expected it beside shape=capsule"},
      {rod + "length=abc", "length: is \"abc\"; expected a number, 1e-09 to 1e+06 m"},
      {rod + "length=1,2", "length: is [1,2]; expected a number"},
      {rod + "length=nan", "length: is \"nan\"; expected a number"},
      {rod + "length=-0.1", "length: is -0.1; expected 1e-09 to 1e+06 m"},
      {rod + "length=0", "length: is 0; expected 1e-09 to 1e+06 m"},
      {ball + "length=1", "length: is no value of a sphere; expected radius, center"},
      {"name=a;jaws={\"shape\":{\"sphere\":{\"radius\":1}}};radius=1", "radius: goes with the name of a shape"},
      {"name=a;shape={\"sphere\":{\"radius\":1}};radius=1", "radius: goes with the name of a shape"},
      {"name=a;shape=sphere;radius=-1;from=0,0,0",
       "instruments[0].shape.sphere.radius: is -1; expected 1e-09 to 1e+06 m"},
      {"name=a;shape=sphere;radius=nan;from=0,0,0",
       "instruments[0].shape.sphere.radius: is \"nan\"; expected a number"},
      {"name=a;shape=cylinder;radius=0.1;length=0.1;round=0.06;from=0,0,0",
       "instruments[0].shape.cylinder.round: is 0.06; expected 0 to 0.05 m, at most the radius and half of the length"},
      {ball + "friction=-1;from=0,0,0", "instruments[0].friction: is -1; expected 0 to 10"},
      {ball + "interpolate=cubic;from=0,0,0",
       "instruments[0].interpolate: is \"cubic\"; expected \"linear\" or \"smooth\""},
      {ball + "grip=1;from=0,0,0", "instruments[0].path[0].grip: has no jaws to close"},
      {ball + "rotate_deg=1;from=0,0,0", "instruments[0].path[0].rotate_deg: is 1; expected a list of 3 numbers"},
      {ball, "from: is missing; expected the place [x, y, z] where it stands [m], or from, to and duration"},
      {ball + "rotate_deg=0,90,0", "from: is missing; expected the place [x, y, z] where it stands [m]"},
      {ball + "from=0,1", "from: is [0,1]; expected a list of 3 numbers [m]"},
      {ball + "from=0,nan,0", "from[1]: is \"nan\"; expected a number"},
      {ball + "from=0,1,0;to=0,0,0", "duration: is missing; expected the seconds until it is at to"},
      {ball + "to=0,0,0", "duration: is missing; expected the seconds until it is at to"},
      {ball + "to=0,0,inf;duration=1", "to[2]: is \"inf\"; expected a number"},
      {ball + "from=0,1,0;duration=1", "to: is missing; expected the place [x, y, z] where it is after duration [m]"},
      {ball + "from=0,1,0;start=1", "to: is missing; expected the place [x, y, z] to which it moves from start on [m]"},
      {ball + "to=0,0,0;duration=-1", "duration: is -1; expected 1e-09 to 1e+09 s"},
      {ball + "to=0,0,0;duration=0", "duration: is 0; expected 1e-09 to 1e+09 s"},
      {ball + "to=0,0,0;duration=x", "duration: is \"x\"; expected a number"},
      {ball + "to=0,0,0;duration=1;start=-1", "start: is -1; expected 0 to 1e+09 s"},
      {ball + "path=[{\"time\":0}];from=0,0,0", "has path and from; expected one of them"},
      {ball + "path=1", "instruments[0].path: is 1; expected a list of keys"},
  };
  for (const auto& [text, begin] : cases) {
    CAPTURE(text);
    CHECK_THAT(error(text), Catch::StartsWith("--instrument: " + begin));
  }
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
            .find("instruments[1]: \"ground\" is the name of instruments[0]; expected a name of its own") !=
        std::string::npos);
  CHECK(error(R"("contact": {"self": 1})").find("s.json: contact.self: is 1; expected") == 0);
}

}  // namespace
}  // namespace fascia
