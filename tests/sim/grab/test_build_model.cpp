#include "sim/grab/build_model.h"

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
