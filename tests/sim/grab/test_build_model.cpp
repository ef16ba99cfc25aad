#include "sim/grab/build_model.h"

#include <algorithm>

#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the thickness of a skin is judged whether or not it touches anything", "[contact]") {
  const auto scene = [](const std::string& contact) {
    return SceneFile(R"({"fascia_scene": 1, "bodies": [{"name": "cube", "mesh": ")" +
                     (source_dir() / "assets/meshes/cube.msh").string() + R"("}], "contact": )" + contact + "}");
  };
  for (const char* contact : {R"({"thickness": 1})", R"({"thickness": 1, "self": true})"}) {
    const SceneFile file = scene(contact);
    CHECK(file.error_of([&] { build_model(file.open()); }) ==
          "s.json: contact.thickness: is 1 m, more than the largest side of cube, 0.1 m; expected less than its "
          "elements, 0.0212 m");
  }
  const auto notes = [&](const std::string& contact) { return build_model(scene(contact).open()).notes; };
  CHECK(notes(R"({"thickness": 0.03})").size() == notes("{}").size() + 1);
  CHECK(notes(R"({"thickness": 0.01})") == notes("{}"));
}

TEST_CASE("a note says where sdirk2 has too few iterations for what is nearly incompressible") {
  const auto says_so = [](const std::string& integrator, int iterations, double ratio, const std::string& elements) {
    const SceneFile file(R"({"fascia_scene": 1, "bodies": [{"name": "cube", "mesh": ")" +
                         (source_dir() / "assets/meshes/cube.msh").string() + R"(", "elements": ")" + elements +
                         R"(", "materials": {"default": {"poisson_ratio": )" + std::to_string(ratio) +
                         R"(}}}], "solver": {"integrator": ")" + integrator + R"(", "iterations": )" +
                         std::to_string(iterations) + "}}");
    const std::vector<std::string> notes = build_model(file.open()).notes;
    return std::any_of(notes.begin(), notes.end(),
                       [](const std::string& note) { return note.find("may gain energy") != std::string::npos; });
  };
  CHECK(says_so("sdirk2", 10, 0.499, "quadratic"));
  CHECK_FALSE(says_so("sdirk2", 40, 0.499, "quadratic"));
  CHECK_FALSE(says_so("sdirk2", 10, 0.49, "quadratic"));
  CHECK_FALSE(says_so("sdirk2", 10, 0.499, "linear"));
  CHECK_FALSE(says_so("bdf2", 10, 0.499, "quadratic"));
}
