// The grabs of a scene: valid input, its meaning, and positions over time.
// Covers: grab_patch, sim/scene/scene_read_grab
#include <algorithm>
#include <cmath>
#include <set>

#include "sim/grab/build_model.h"
#include "sim/grab/grab_patch.h"
#include "sim/grab/resolve_grab.h"
#include "sim/mesh/mid_edges.h"
#include "sim/model/model.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// The shipped cube with these grabs.
std::string with_grabs(const std::string& grabs) {
  return R"({"fascia_scene": 1, "bodies": [{"name": "cube", "mesh": ")" +
         (source_dir() / "assets/meshes/cube.msh").string() + R"(", "fixed": [{"lowest": 0.02}]}], "grabs": )" + grabs +
         "}";
}

std::string model_error(const std::string& grabs) {
  const SceneFile file(with_grabs(grabs));
  return file.error_of([&] { build_model(file.open()); });
}

// A point in the middle of the cube's top.
Vector3d top_of_cube() {
  const Model model = build_model(SceneFile(with_grabs("[]")).open());
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (const Vector3d& x : model.rest_positions) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return {(low.x() + high.x()) / 2, high.y(), (low.z() + high.z()) / 2};
}

std::string text_of(const Vector3d& v) {
  char text[100];
  std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g", v.x(), v.y(), v.z());
  return text;
}

}  // namespace

TEST_CASE("grabs of a scene are written as they were read") {
  const SceneFile file(with_grabs(R"([
    {"at": [0.1, 0.2, 0.30000000000000004], "translate": [0, 0.1, 0], "start": 0.25, "duration": 0.5, "release": 1.5, "radius": 0.02},
    {"select": {"box": [[0, 0, 0], [1, 1, 1]]}, "body": "cube", "stiffness": 123.5, "path": [[0.1, 0, 0, 0.01], [0.7, 0.1, 0, 0]], "smooth": true},
    {"at": [0, 0, 0], "push": 0.013, "duration": 0.1}])"));
  const Scene scene = file.open();
  REQUIRE(scene.grabs.size() == 3);
  CHECK(scene.grabs[0].release == 1.5);
  CHECK(scene.grabs[1].path[1].displacement == Vector3d(0.1, 0, 0));
  CHECK(scene.grabs[2].push == 0.013);
  write_file(file / "again.json", scene_to_json(scene, (file / "again.json").parent_path()));
  CHECK(open_scene(file / "again.json").grabs == scene.grabs);
  const SceneFile none(with_grabs("[]"));
  CHECK(scene_to_json(none.open(), none.path().parent_path()).find("grabs") == std::string::npos);
}

TEST_CASE("an invalid grab is one clear line") {
  const auto error = [](const std::string& grabs) { return SceneFile(with_grabs(grabs)).open_error(); };
  CHECK(error(R"([{"at": [0, 0, 0], "translat": [1, 0, 0]}])") ==
        "s.json: grabs[0].translat: unknown key \"translat\", perhaps \"translate\"; expected one of at, select, body, "
        "radius, stiffness, start, duration, release, smooth, translate, push, path");
  CHECK(error(R"([{"translate": [1, 0, 0]}])") ==
        "s.json: grabs[0]: holds nothing; expected at, a place [x, y, z] on the tissue [m], or select");
  CHECK(error(R"([{"at": [0, 0, 0], "push": 1, "path": [[0, 0, 0, 0]]}])") ==
        "s.json: grabs[0]: has more than one of translate, push and path; expected one of them");
  CHECK(error(R"([{"at": [0, 0, 0], "path": [[1, 0, 0, 0], [1, 0, 0, 0]]}])") ==
        "s.json: grabs[0].path[1]: is [1,0,0,0]; expected a later time than that of the key before");
  CHECK(error(R"([{"at": [0, 0, 0], "start": 2, "release": 1}])") ==
        "s.json: grabs[0].release: is 1; expected a time after start");
  CHECK(error(R"([{"at": [0, 0, 0], "radius": 0}])") == "s.json: grabs[0].radius: is 0; expected 1e-09 to 1e+06 m");
  CHECK(model_error(R"([{"at": [50, 0, 0]}])").find("s.json: grabs[0].at: 4") == 0);  // 49.9 m from the nearest vertex
  CHECK(model_error(R"([{"at": [0, 0, 0], "body": "cub"}])") ==
        "s.json: grabs[0].body: there is no body \"cub\", perhaps \"cube\"; expected one of cube");
  CHECK(model_error(R"([{"select": {"lowest": 0.001}}])") ==
        "s.json: grabs[0]: holds only vertices that are fixed or prescribed; expected a free one");
}

TEST_CASE("a grab on the command line is added to the scene's") {
  const SceneFile file(with_grabs(R"([{"at": [0, 0, 0]}])"));
  const Scene scene =
      file.open({"--grab at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02",
                 "--grab at=0,0,0;path=0,0,0,0/0.5,0,0.1,0;smooth=true;body=cube"});
  REQUIRE(scene.grabs.size() == 3);
  ScriptedGrab first;
  first.where = Vector3d(0.1, 0.05, 0);
  first.translate = {0, 0.1, 0};
  first.start = 0.2;
  first.duration = 0.5;
  first.release = 1.5;
  first.radius = 0.02;
  CHECK(scene.grabs[1] == first);
  CHECK(scene.grabs[2].path == std::vector<ScriptedGrab::Key>{{0, {0, 0, 0}}, {0.5, {0, 0.1, 0}}});
  CHECK(scene.grabs[2].smooth);
  CHECK(scene.grabs[2].body == "cube");
  CHECK(file.open({"--grab at=0,0,0;body=2"}).grabs[1].body == "2");
  CHECK(file.open({"grabs.0.radius=0.5"}).grabs[0].radius == 0.5);
  const Scene json = file.open({"--grab select={\"vertices\": [1, 2]}; translate=[0, 0.1, 0]",
                                "--grab at=0,0,0;path=[[0, 0, 0, 0], [1, 0, 0.1, 0]]"});
  CHECK(std::get<Selection>(json.grabs[1].where) == Selection(VertexSelection{{1, 2}}));
  CHECK(json.grabs[1].translate == Vector3d(0, 0.1, 0));
  CHECK(json.grabs[2].path == std::vector<ScriptedGrab::Key>{{0, {0, 0, 0}}, {1, {0, 0.1, 0}}});

  CHECK(file.open_error({"--grab at"}) ==
        "--grab: at is not KEY=VALUE; expected such as at=0.1,0.05,0;translate=0,0.1,0");
  CHECK(file.open_error({"--grab select={\"vertices\""}).starts_with("--grab select:1:12: "));
  CHECK(file.open_error({"--grab at=0,0,0;at=1,1,1"}) == "--grab: at is given twice; expected each key once");
  CHECK(file.open_error({"--grab at=0,zero,0"}) ==
        "--grab: grabs[1].at[1]: is \"zero\"; expected a number, -1e+06 to 1e+06 m");
}

TEST_CASE("a scripted grab follows its path, never faster than a grab may be, and pulls from start to release") {
  const std::string at = text_of(top_of_cube());
  const auto grab = [&](const std::string& rest) {
    return build_model(SceneFile(with_grabs("[{\"at\": [" + at + "], " + rest + "}]")).open()).grabs.front();
  };
  const ResolvedGrab straight = grab(R"("translate": [0, 0.02, 0], "start": 0.5, "duration": 0.4, "release": 2)");
  CHECK(straight.displacement(0.4).norm() == 0);
  CHECK((straight.displacement(0.6) - Vector3d(0, 0.005, 0)).norm() < 1e-15);
  CHECK(straight.displacement(5) == Vector3d(0, 0.02, 0));
  CHECK(straight.end() == 2);
  const std::vector<ResolvedGrab> grabs{straight};
  CHECK(with_grabs({}, grabs, 0.5).empty());
  CHECK(with_grabs({}, grabs, 0.51).size() == straight.grip.size());
  CHECK(with_grabs({}, grabs, 2.01).empty());
  CHECK(with_grabs_at_last({}, grabs).front().target == Vector3d(0, 0.02, 0));

  const ResolvedGrab smooth = grab(R"("path": [[1, 0.02, 0, 0], [2, 0, 0, 0.02]], "smooth": true)");
  CHECK((smooth.displacement(0.25) - Vector3d((3 - 0.5) / 16 * 0.02, 0, 0)).norm() < 1e-15);  // s^2 (3 - 2 s)
  CHECK((smooth.displacement(1.5) - Vector3d(0.01, 0, 0.01)).norm() < 1e-15);

  // A jump, and a path back and forth that is far faster than any grab.
  const double size = scene_radius(build_model(SceneFile(with_grabs("[]")).open()));
  for (const char* wild : {R"("translate": [5, 0, 0])", R"("path": [[0.001, 3, 0, 0], [0.002, -3, 0, 0]])",
                           R"("path": [[0.001, 3, 0, 0]], "smooth": true)"}) {
    const ResolvedGrab fast = grab(wild);
    CAPTURE(wild);
    double fastest = 0;
    constexpr double kStep = 1e-4;
    for (double t = 0; t < fast.end() + 0.1; t += kStep)
      fastest = std::max(fastest, (fast.displacement(t + kStep) - fast.displacement(t)).norm() / kStep);
    CHECK(fastest <= kGrabSpeed * size * (1 + 1e-6));
    CHECK(fastest > 0.9 * kGrabSpeed * size);
  }

  // A push goes into the surface: down from the top.
  const ResolvedGrab push = grab(R"("push": 0.01)");
  CHECK((push.path.back().displacement - Vector3d(0, -0.01, 0)).norm() < 1e-6);
}

TEST_CASE("shares of a patch add up to one, also if it is smaller than a tet") {
  const Model model = build_model(SceneFile(with_grabs("[]")).open());
  const Vector3d at = top_of_cube() + Vector3d(0.003, 0, 0.002);
  const EmbeddedPoint place = tet_at(model.tets, model.rest_positions, at);
  for (const double radius : {1e-6, 0.01, 0.1}) {
    CAPTURE(radius);
    const std::vector<PatchVertex> patch = grab_patch(model, model.rest_positions, at, radius, place);
    double sum = 0;
    Vector3d middle(0, 0, 0);
    for (const PatchVertex& p : patch) sum += p.share, middle += p.share * model.rest_positions[p.vertex];
    CHECK(sum == Approx(1));
    // Only the point's own tet: the pull acts exactly at the point.
    if (radius == 1e-6) CHECK((middle - at).norm() < 1e-9);
    CHECK((middle - at).norm() < std::max(radius, 1e-9));
    CHECK(patch_stiffness(patch, radius) == Approx(kGrip * model.materials[0].young_modulus * radius));
  }
}

// An even pressure on a face of a quadratic tet acts on the middles of its edges, a third each.
TEST_CASE("grabs of quadratic tets pull the middles of edges, or a single corner") {
  const Vector3d top = top_of_cube();
  const SceneFile file(with_grabs("[{\"at\": [" + text_of(top) + "], \"translate\": [0, 0.01, 0], \"radius\": 0.04}]"));
  const auto middles_of = [](const Model& model) {
    std::set<std::uint32_t> middles;
    for (const MidEdge& edge : mid_edges_of(model.file_mesh)) middles.insert(edge.vertex);
    return middles;
  };
  const Model model = build_model(file.open({"elements=quadratic"}));
  REQUIRE(model.grabs.size() == 1);
  REQUIRE(!model.grabs[0].grip.empty());
  const std::set<std::uint32_t> middles = middles_of(model);
  double stiffness = 0;
  Vector3d place(0, 0, 0);
  for (const GrabSpring& spring : model.grabs[0].grip) {
    CHECK(middles.count(spring.vertex) == 1);
    stiffness += spring.stiffness;
    place += spring.stiffness * model.rest_positions[spring.vertex];
  }
  CAPTURE(model.grabs[0].grip.size(), stiffness, (place / stiffness).transpose(), top.transpose());
  CHECK((place / stiffness - top).norm() < 0.04);
  double linear = 0;
  const Model of_corners = build_model(file.open());
  for (const GrabSpring& spring : of_corners.grabs[0].grip) linear += spring.stiffness;
  CHECK(stiffness == Approx(linear).epsilon(1e-12));

  // Selected corners bring the middles between them.
  const std::vector<char> held = model.held();
  const Tet& tet = *std::find_if(model.tets.begin(), model.tets.end(), [&](const Tet& t) {
    return std::none_of(t.begin(), t.end(), [&](std::uint32_t v) { return held[v]; });
  });
  const std::vector<PatchVertex> even = even_patch(model, {tet.begin(), tet.end()});
  double share = 0;
  for (const PatchVertex& p : even) {
    CHECK(middles.count(p.vertex) == 1);
    share += p.share;
  }
  CHECK(even.size() == 6);
  CHECK(share == Approx(1).epsilon(1e-12));
  const std::uint32_t corner = tet[0];
  const std::vector<PatchVertex> one =
      grab_patch(model, model.rest_positions, model.rest_positions[corner], 1e-6, {tet, {1, 0, 0, 0}});
  REQUIRE(one.size() == 1);
  CHECK(one[0].vertex == corner);
}
