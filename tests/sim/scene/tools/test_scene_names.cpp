// Each name of a scene belongs to one body or tool.
// Covers: scene_names
#include "sim/scene/tools/scene_names.h"

#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string scene_of(const std::string& bodies, const std::string& top = "") {
  return "{\"fascia_scene\": 1, \"bodies\": [" + bodies + "]" + (top.empty() ? "" : ", " + top) + "}";
}

const std::string kSphere = R"("shape": {"sphere": {"radius": 1}})";

}  // namespace

TEST_CASE("a name given twice is an error, of bodies and tools in any order") {
  const std::string a = R"({"name": "a", "mesh": "m.msh"})", other = R"({"name": "b", "mesh": "m.msh"})";
  const auto error = [](const std::string& text) { return SceneFile(text).open_error(); };
  const std::string expected = "; expected a name of its own, which statistics use";
  CHECK(error(scene_of(a + "," + a)) == "s.json: bodies[1].name: \"a\" is the name of bodies[0]" + expected);
  CHECK(error(scene_of(a, "\"instruments\": [{\"name\": \"a\", " + kSphere + "}]")) ==
        "s.json: instruments[0]: \"a\" is the name of bodies[0]" + expected);
  CHECK(error(scene_of(a, "\"obstacles\": [{\"name\": \"a\", " + kSphere + "}]")) ==
        "s.json: obstacles[0]: \"a\" is the name of bodies[0]" + expected);
  CHECK(error(scene_of(a, "\"ground\": {}, \"obstacles\": [{\"name\": \"ground\", " + kSphere + "}]")) ==
        "s.json: obstacles[0]: \"ground\" is the name of the ground" + expected);
  CHECK(error(scene_of(R"({"name": "ground", "mesh": "m.msh"})", "\"ground\": {}")) ==
        "s.json: bodies[0].name: \"ground\" is the name of the ground" + expected);
  CHECK(error(scene_of(R"({"name": "b,c", "mesh": "m.msh"}, {"name": "b_c", "mesh": "m.msh"})")) ==
        "s.json: bodies[1].name: \"b_c\" is the name of bodies[0]" + expected);  // the same columns
  CHECK(SceneFile(scene_of(a + "," + other)).open().bodies.size() == 2);
  CHECK(SceneFile(scene_of(a)).open_error({"--instrument name=a;shape=sphere;radius=1;from=0,0,0"}) ==
        "--instrument: \"a\" is the name of bodies[0]" + expected);
  CHECK(SceneFile(scene_of(a)).open_error({"bodies[1].mesh=m.msh", "bodies[1].name=a"}) ==
        "--set bodies[1].name: \"a\" is the name of bodies[0]" + expected);
}

TEST_CASE("bodies without a name get distinct ones, which no other body or tool has") {
  const SceneFile file(scene_of(R"({"mesh": "a/m.msh"}, {"name": "m 2", "mesh": "m.msh"}, {"mesh": "m.msh"},
                                   {"name": "", "mesh": "m.obj"}, {"mesh": "ground.msh"})",
                                "\"ground\": {}"));
  const Scene scene = file.open();
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) names.push_back(body.name);
  CHECK(names == std::vector<std::string>{"m", "m 2", "m 3", "m 4", "ground 2"});
  const SceneFile again(scene_to_json(scene, file.path().parent_path()), "again.json");
  CHECK(again.open().bodies == scene.bodies);
}

TEST_CASE("columns of two bodies in contact are those of no tool and no other two bodies") {
  const auto bodies = [](const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
      text += std::string(text.empty() ? "" : ", ") + "{\"name\": \"" + name + "\", \"mesh\": \"m.msh\"}";
    return text;
  };
  const auto tool = [](const std::string& kind, const std::string& name) {
    return ", \"" + kind + "\": [{\"name\": \"" + name + "\", " + kSphere + "}]";
  };
  const auto error = [](const std::string& text) { return SceneFile(text).open_error(); };
  const std::string contact = "\"contact\": {}", apart = "\"contact\": {\"bodies\": false}",
                    self = "\"contact\": {\"bodies\": false, \"self\": true}";
  CHECK(error(scene_of(bodies({"a", "b"}), contact + tool("instruments", "a_b"))) ==
        "s.json: contact: the bodies \"a\" and \"b\" would share the columns contact_a_b of histories with the "
        "instrument "
        "\"a_b\"; expected other names");
  CHECK(
      error(scene_of(bodies({"a"}), self + tool("obstacles", "a_a"))) ==
      "s.json: contact: the body \"a\" with itself would share the columns contact_a_a of histories with the obstacle "
      "\"a_a\"; expected other names");
  CHECK(error(scene_of(bodies({"a", "a_b", "b_c", "c"}), contact)) ==
        "s.json: contact: the bodies \"a_b\" and \"c\" would share the columns contact_a_b_c of histories with the "
        "bodies "
        "\"a\" and \"b_c\"; expected other names");
  CHECK(SceneFile(scene_of(bodies({"a", "b"}), apart + tool("instruments", "a_b"))).open().bodies.size() == 2);
  CHECK(SceneFile(scene_of(bodies({"b", "a"}), contact + tool("instruments", "a_b"))).open().bodies.size() == 2);
  CHECK(SceneFile(scene_of(bodies({"a", "b", "a_b"}), contact)).open().bodies.size() == 3);
}
