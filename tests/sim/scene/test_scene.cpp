// Valid scenes: defaults, every key, both kinds of file, round trip.
// Covers: scene_read, scene_read_display, scene_write
#include <sys/stat.h>

#include <fstream>
#include <set>
#include <thread>

#include "sim/grab/build_model.h"
#include "sim/model/model.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const char* const kFullScene = R"({
  "fascia_scene": 1, "title": "All keys", "gravity": [0.1, -1.62, 0],
  "bodies": [
    {"name": "beam", "mesh": "../bars/beam.msh",
     "transform": {"scale": 0.001, "rotate_deg": [10, 20, 30], "translate": [1, 2, 3]},
     "materials": {"default": {"young_modulus": 1e6, "poisson_ratio": 0.45, "density": 1060, "damping": 0.02,
                               "model": "st_venant_kirchhoff"},
                   "2": {"young_modulus": 1e7}, "tumour": {"poisson_ratio": 0.1, "model": "st_venant_kirchhoff"}},
     "regions": [{"name": "tumour", "tets": [7, [2, 5], 6, 11, [12, 12]]}, {"name": "9", "tets": [0]}],
     "fixed": [{"box": [[-1e-5, -1, -1], [1e-5, 1, 1]]}, {"sphere": {"center": [1, 2, 3], "radius": 0.25}},
               {"vertices": [0, 4, 9]}, {"group": "clamp"}, {"lowest": 0.05}],
     "prescribed": [{"select": {"box": [[0.39, -1, -1], [0.41, 1, 1]]}, "translate": [0.1, 0, 0],
                     "rotate_deg": {"axis": [1, 1, 0], "angle": 90, "center": [0, 0.5, 0]}, "scale": 1.5,
                     "start": 0.25, "duration": 0.5},
                    {"targets": "prescribed.csv", "start": 0.125, "duration": 0.75}],
     "initial_velocity": "initial_velocity.csv", "surface": "liver.obj"},
    {"mesh": "cube.msh", "initial_velocity": [0, 0, -0.1]}],
  "solver": {"method": "jacobi", "acceleration": "none", "iterations": 10, "tolerance": 1e-6,
             "time_step": 0.016666666666666666, "substeps": 3},
  "camera": {"eye": [0, 0.3, 1], "target": [0, 0.1, 0], "up": [0, 0, 1], "fov_deg": 35},
  "display": {"color": "von_mises", "range": [0, 2.5e4], "color_map": "ember", "wireframe": true,
              "section": {"normal": [0, 1, 1], "offset": -0.02}, "tets": {"shrink": 0.5, "spread": 0.25},
              "shadow": false, "ground": false, "ambient_occlusion": 0.75, "depth_cue": 0.5, "background": "transparent",
              "marks": ["fixed", "forces"], "legend": {"side": "left", "font_size": 20, "plate": false}},
  "duration": 2.5
})";

}  // namespace

TEST_CASE("a scene with only a mesh has the documented defaults") {
  const SceneFile file(scene_text());
  const Scene scene = file.open();
  CHECK(scene.file == file.path());
  CHECK(scene.title.empty());
  CHECK(scene.gravity == Eigen::Vector3d(0, -9.81, 0));
  CHECK(scene.duration == 2);
  CHECK(!scene.camera);
  CHECK(scene.display == DisplaySettings{});
  CHECK(scene.solver == SolverSettings{});
  CHECK(SolverChoice{scene.solver.method, scene.solver.acceleration} == solver_choices().front());
  REQUIRE(scene.bodies.size() == 1);
  const Body& body = scene.bodies[0];
  CHECK(body.name == "m");
  CHECK(body.mesh == "m.msh");
  CHECK(body.material == Material{});
  CHECK(body.transform == Transform{});
  CHECK(body.region_materials.empty());
  CHECK(body.fixed.empty());
  CHECK(body.prescribed.empty());
  CHECK(std::get<Eigen::Vector3d>(body.initial_velocity) == Eigen::Vector3d(0, 0, 0));
  CHECK(body.surface.empty());
  CHECK(scene.resolve(body.mesh) == file / "m.msh");
  CHECK(scene.resolve("/elsewhere/m.msh") == "/elsewhere/m.msh");
}

TEST_CASE("every key of a scene is read") {
  const Scene scene = SceneFile(kFullScene).open();
  CHECK(scene.title == "All keys");
  CHECK(scene.gravity == Eigen::Vector3d(0.1, -1.62, 0));
  CHECK(scene.duration == 2.5);
  CHECK(scene.solver.iterations == 10);
  CHECK(scene.solver.tolerance == 1e-6);
  CHECK(scene.solver.time_step == 1.0 / 60.0);
  CHECK(scene.solver.substeps == 3);
  REQUIRE(scene.camera);
  CHECK(*scene.camera == CameraSettings{{0, 0.3, 1}, {0, 0.1, 0}, {0, 0, 1}, 35});
  CHECK(scene.display == DisplaySettings{ColorBy::von_mises, Eigen::Vector2d(0, 2.5e4), ColorMap::ember, true,
                                         SectionPlane{{0, 1, 1}, -0.02}, SeparateTets{0.5, 0.25}, false, false, 0.75,
                                         0.5, Background::transparent, MarkSettings{true, false, true},
                                         LegendSettings{LegendSide::left, 20, false}});
  REQUIRE(scene.bodies.size() == 2);

  const Body& body = scene.bodies[0];
  CHECK(body.name == "beam");
  CHECK(body.mesh == "../bars/beam.msh");
  CHECK(body.surface == "liver.obj");
  CHECK(body.transform == Transform{0.001, {10, 20, 30}, {1, 2, 3}});
  CHECK(body.material == Material{1e6, 0.45, 1060, 0.02, MaterialModel::st_venant_kirchhoff});
  REQUIRE(body.region_materials.size() == 2);
  CHECK(body.region_materials[0].first == "2");
  CHECK(body.region_materials[0].second == MaterialOverride{1e7, {}, {}, {}, {}});
  CHECK(body.region_materials[1].first == "tumour");
  CHECK(body.region_materials[1].second == MaterialOverride{{}, 0.1, {}, {}, MaterialModel::st_venant_kirchhoff});

  CHECK(body.regions == std::vector<TetRegion>{{"tumour", {{2, 7}, {11, 12}}}, {"9", {{0, 0}}}});

  REQUIRE(body.fixed.size() == 5);
  CHECK(body.fixed[0] == Selection(BoxSelection{{-1e-5, -1, -1}, {1e-5, 1, 1}}));
  CHECK(body.fixed[1] == Selection(SphereSelection{{1, 2, 3}, 0.25}));
  CHECK(body.fixed[2] == Selection(VertexSelection{{0, 4, 9}}));
  CHECK(body.fixed[3] == Selection(GroupSelection{"clamp"}));
  CHECK(body.fixed[4] == Selection(LowestSelection{0.05}));

  REQUIRE(body.prescribed.size() == 2);
  const PrescribedMotion& moved = body.prescribed[0];
  CHECK(moved.select == Selection(BoxSelection{{0.39, -1, -1}, {0.41, 1, 1}}));
  CHECK(moved.translate == Eigen::Vector3d(0.1, 0, 0));
  CHECK(moved.axis == Eigen::Vector3d(1, 1, 0));
  CHECK(moved.angle_deg == 90);
  CHECK(moved.center == Eigen::Vector3d(0, 0.5, 0));
  CHECK(moved.scale == 1.5);
  CHECK(moved.targets.empty());
  CHECK(moved.start == 0.25);
  CHECK(moved.duration == 0.5);
  const PrescribedMotion& targeted = body.prescribed[1];
  CHECK(!targeted.select);
  CHECK(targeted.targets == "prescribed.csv");
  CHECK(targeted.start == 0.125);
  CHECK(targeted.duration == 0.75);
  CHECK(std::get<std::string>(body.initial_velocity) == "initial_velocity.csv");
  CHECK(std::get<Eigen::Vector3d>(scene.bodies[1].initial_velocity) == Eigen::Vector3d(0, 0, -0.1));
}

TEST_CASE("a solver section gets the best solver choice with its names") {
  const SolverChoice best = solver_choices().front();
  for (const SolverChoice& pair : solver_choices()) {
    const std::string method = name_of(pair.method), acceleration = name_of(pair.acceleration);
    CAPTURE(method, acceleration);
    const auto pair_of = [](const std::string& solver) {
      const SolverSettings settings = SceneFile(scene_text("", "\"solver\": " + solver)).open().solver;
      return SolverChoice{settings.method, settings.acceleration};
    };
    CHECK(pair_of("{\"method\": \"" + method + "\", \"acceleration\": \"" + acceleration + "\"}") == pair);
    CHECK(pair_of("{\"method\": \"" + method + "\"}") == find_choice(method, {}));
    CHECK(pair_of("{\"acceleration\": \"" + acceleration + "\"}") == find_choice({}, acceleration));
    CHECK(pair_of("{}") == best);
  }
}

TEST_CASE("a mesh on its own is a body that leaves open what its file does not state") {
  const SceneFile file("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "liver.msh");
  const Scene scene = file.open();
  CHECK(scene.file == file.path());
  CHECK(scene.title == "liver.msh");
  REQUIRE(scene.bodies.size() == 1);
  CHECK(scene.bodies[0].name == "liver");
  CHECK(scene.resolve(scene.bodies[0].mesh) == file.path());
  CHECK(scene.bodies[0].material == Material{});
  CHECK(scene.bodies[0].fixed.empty());
  CHECK(scene.unsettled == Unsettled());

  const auto left_open = [&](const std::vector<std::string>& overrides) {
    const Scene with = open_scene(file.path(), overrides);
    REQUIRE(with.unsettled);
    CHECK(with.unsettled->overrides == overrides);
    const Unsettled& u = *with.unsettled;
    return std::vector<bool>{u.unit, u.up, u.supports, u.stiffness, u.law};
  };
  CHECK(left_open({"unit=mm"}) == std::vector<bool>{false, true, true, true, true});
  CHECK(left_open({"up=-z"}) == std::vector<bool>{true, false, true, true, true});
  CHECK(left_open({"fixed=[]"}) == std::vector<bool>{true, true, false, true, true});
  CHECK(left_open({"fixed.0.highest=0.1"}) == std::vector<bool>{true, true, false, true, true});
  CHECK(left_open({"materials.default.young_modulus=5"}) == std::vector<bool>{true, true, true, false, true});
  CHECK(left_open({"materials.default.preset=liver"}) == std::vector<bool>{true, true, true, false, true});
  CHECK(left_open({"materials.default.model=neo_hookean"}) == std::vector<bool>{true, true, true, true, false});
  CHECK(left_open({"materials.default.density=900"}) == std::vector<bool>{true, true, true, true, true});
}

TEST_CASE("a scene in a file leaves nothing open, and keeps unit, axis and supports when it is written") {
  const std::string keys =
      R"("unit": "mm", "up": "-z", "fixed": [{"highest": 0.1}, {"lowest": 0.2, "each_piece": true}])";
  const Scene scene = SceneFile(scene_text(keys)).open();
  CHECK(!scene.unsettled);
  const Body& body = scene.bodies[0];
  CHECK(body.unit == LengthUnit::mm);
  CHECK(body.up == UpAxis::minus_z);
  CHECK(body.fixed == std::vector<Selection>{LowestSelection{0.1, true}, LowestSelection{0.2, false, true}});
  CHECK(SceneFile(scene_to_json(scene, scene.file.parent_path())).open().bodies == scene.bodies);
  const Scene plain = SceneFile(scene_text("")).open();
  CHECK(!plain.unsettled);
  CHECK(plain.bodies[0].unit == LengthUnit::m);
  CHECK(plain.bodies[0].up == UpAxis::y);
}

TEST_CASE("a scene is distinguished from a mesh by its content, or by the extension .json") {
  CHECK(SceneFile("\n\t " + scene_text(), "scene.txt").open().bodies[0].mesh == "m.msh");
  CHECK(SceneFile("\xEF\xBB\xBF" + scene_text(), "scene.txt").open().bodies[0].mesh == "m.msh");
  CHECK(SceneFile("# vtk", "x.txt").open().bodies[0].mesh == "x.txt");
  CHECK(SceneFile("\xEF\xBB\xBF# vtk", "x.txt").open().bodies[0].mesh == "x.txt");
  CHECK(SceneFile("\"fascia_scene\": 1}", "s.json").open_error().find("s.json:1:15: ") == 0);
}

TEST_CASE("a written scene opens as the same scene") {
  const SceneFile file(kFullScene);
  const Scene scene = file.open();
  const std::string text = scene_to_json(scene, file.path().parent_path());
  INFO(text);
  write_file(file.path(), text);
  CHECK(file.open() == scene);
  CHECK(scene_to_json(file.open(), file.path().parent_path()) == text);
}

TEST_CASE("numbers survive the round trip to the last bit") {
  const SceneFile file(scene_text());
  Scene scene = file.open();
  for (const double value : {0.1, 1.0 / 3.0, 1e-3, 99999999999999.98, 123456.7, 5e-324 * 1e300, 2.0 / 3.0 * 1e-2}) {
    CAPTURE(value);
    scene.gravity = {value / 1e14, -value / 1e14, -0.0};
    scene.duration = value / 1e14;
    scene.solver.time_step = 1.0 / 60.0;
    scene.bodies[0].fixed = {BoxSelection{{-value, -value, -value}, {value, value, value}}};
    write_file(file.path(), scene_to_json(scene, file.path().parent_path()));
    CHECK(file.open() == scene);
  }
}

TEST_CASE("a scene written to another folder finds the same files") {
  const SceneFile file(kFullScene);
  const Scene scene = file.open();
  const std::filesystem::path other = file / "deep/er";
  std::filesystem::create_directories(other);
  write_file(other / "copy.json", scene_to_json(scene, other));
  const Scene copy = open_scene(other / "copy.json");
  const auto same = [](const std::filesystem::path& a, const std::filesystem::path& b) {
    CAPTURE(a, b);
    CHECK(std::filesystem::weakly_canonical(a) == std::filesystem::weakly_canonical(b));
  };
  same(copy.resolve(copy.bodies[0].mesh), scene.resolve(scene.bodies[0].mesh));
  same(copy.resolve(copy.bodies[0].surface), scene.resolve(scene.bodies[0].surface));
  same(copy.resolve(copy.bodies[0].prescribed[1].targets), scene.resolve(scene.bodies[0].prescribed[1].targets));
  same(copy.resolve(std::get<std::string>(copy.bodies[0].initial_velocity)),
       scene.resolve(std::get<std::string>(scene.bodies[0].initial_velocity)));
  CHECK(std::filesystem::path(copy.bodies[1].mesh).is_absolute());  // not below the copy's folder
}

TEST_CASE("a written scene is readable: lists of numbers on one line, no needless digits") {
  const SceneFile file(
      scene_text(R"("fixed": [{"vertices": [0, 1, 2]}, {"lowest": 0.02}])", R"("solver": {"method": "jacobi"})"));
  CHECK(scene_to_json(file.open(), file.path().parent_path()) == R"({
  "fascia_scene": 1,
  "title": "",
  "gravity": [0, -9.81, 0],
  "bodies": [
    {
      "name": "m",
      "mesh": "m.msh",
      "transform": {"scale": 1, "rotate_deg": [0, 0, 0], "translate": [0, 0, 0]},
      "materials": {
        "default": {
          "young_modulus": 100000,
          "poisson_ratio": 0.3,
          "density": 1000,
          "damping": 0,
          "model": "signed_st_venant_kirchhoff"
        }
      },
      "fixed": [{"vertices": [0, 1, 2]}, {"lowest": 0.02}],
      "prescribed": [],
      "initial_velocity": [0, 0, 0]
    }
  ],
  "solver": {
    "method": "jacobi",
    "acceleration": "none",
    "integrator": "implicit_euler",
    "iterations": 10,
    "tolerance": 0,
    "time_step": 0.016666666666666666,
    "substeps": 1,
    "frame_budget": 0,
    "colors": 0,
    "spectral_radius": 0,
    "window": 5,
    "rest_speed": 1e-05
  },
  "display": {
    "color": "none",
    "color_map": "automatic",
    "wireframe": false,
    "shadow": true,
    "ground": true,
    "ambient_occlusion": 0,
    "depth_cue": 0,
    "background": "gradient",
    "marks": true,
    "legend": {"side": "right", "font_size": 14.5, "plate": true}
  },
  "duration": 2
}
)");
}

TEST_CASE("texts that are not UTF-8 are written with replacements instead of failing") {
  const SceneFile file(scene_text());
  const Scene scene = file.open({"title=a\xff", "materials.\xfe.density=900"});
  const std::string text = scene_to_json(scene, file.path().parent_path());
  CHECK(text.find("\"title\": \"a\xef\xbf\xbd\"") != std::string::npos);
  CHECK(text.find("\"\xef\xbf\xbd\": {\"density\": 900}") != std::string::npos);
}

TEST_CASE("names of display choices are found again, and are unique") {
  const auto check = [](const char* key, const auto& choices, auto member) {
    std::set<std::string> names;
    for (const auto choice : choices) {
      CAPTURE(key, name_of(choice));
      CHECK(names.insert(name_of(choice)).second);
      const Scene scene = SceneFile(scene_text()).open({std::string("display.") + key + "=" + name_of(choice)});
      CHECK(scene.display.*member == choice);
    }
  };
  check("color", all_colors(), &DisplaySettings::color);
  check("color_map", all_color_maps(), &DisplaySettings::color_map);
  check("background", all_backgrounds(), &DisplaySettings::background);
}

TEST_CASE("one value of a section or of separate tets turns them on") {
  const SceneFile file(scene_text());
  CHECK(file.open({"display.section.offset=0.02"}).display.section == SectionPlane{{1, 0, 0}, 0.02});
  CHECK(file.open({"display.section.normal=[0,0,-2]"}).display.section == SectionPlane{{0, 0, -2}, 0});
  CHECK(file.open({"display.tets.spread=0.5"}).display.tets == SeparateTets{0.85, 0.5});
  CHECK(!file.open().display.section);
}

TEST_CASE("a mesh from a pipe is opened like one from a file") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const std::string content = read_file(source_dir() / "assets/meshes/cube.msh");
  std::jthread writer([&] { std::ofstream(folder / "pipe") << content; });
  const Scene scene = open_scene(folder / "pipe");
  CHECK(build_model(scene).tets == build_model(open_scene(source_dir() / "assets/meshes/cube.msh")).tets);
}

TEST_CASE("a scene file that names no law keeps St. Venant-Kirchhoff's, also with a tissue") {
  const auto law = [](const Scene& scene) { return std::string(name_of(scene.bodies[0].material.model)); };
  CHECK(law(SceneFile(scene_text(R"("materials": {"default": {}})")).open()) == "signed_st_venant_kirchhoff");
  CHECK(law(SceneFile(scene_text(R"("materials": {"default": {"preset": "liver"}})")).open()) ==
        "signed_st_venant_kirchhoff");
}

TEST_CASE("a number of one law is written if the law reads it or it is no default, and in overrides always") {
  const auto written = [](const std::string& materials) {
    const SceneFile file(scene_text("\"materials\": " + materials));
    const Scene scene = file.open();
    const std::string text = scene_to_json(scene, file.path().parent_path());
    write_file(file.path(), text);
    CHECK(file.open() == scene);
    return text.find("mooney_ratio") != std::string::npos;
  };
  CHECK_FALSE(written(R"({"default": {"model": "neo_hookean"}})"));
  CHECK(written(R"({"default": {"model": "neo_hookean", "mooney_ratio": 0.4}})"));
  CHECK(written(R"({"default": {"model": "mooney_rivlin"}})"));
  CHECK(written(R"({"default": {}, "2": {"mooney_ratio": 0.2}})"));
}

TEST_CASE("marks are all, none or some, also on the command line") {
  const auto marks = [](const std::string& value) {
    return SceneFile(scene_text()).open({"display.marks=" + value}).display.marks;
  };
  CHECK(SceneFile(scene_text()).open().display.marks == MarkSettings{true, true, true});
  CHECK(marks("true") == MarkSettings{true, true, true});
  CHECK(marks("false") == MarkSettings{false, false, false});
  CHECK(marks("[]") == MarkSettings{false, false, false});
  CHECK(marks(R"(["forces","fixed"])") == MarkSettings{true, false, true});
}

TEST_CASE("a camera that moves has a place or is framed on the bodies") {
  const SceneFile file(scene_text("", R"("camera": {"keys": [{"time": 0}, {"time": 2, "orbit_deg": 90}]})"));
  const Scene framed = file.open();
  CHECK(!framed.camera);
  REQUIRE(framed.camera_motion.keys.size() == 2);
  CHECK(framed.camera_motion.keys[1].orbit_deg == 90.0);
  CHECK(framed.camera_motion.smooth);
  const Scene placed = file.open({"camera.eye=[0,1,2]", "camera.smooth=false", "camera.keys[1].time=3"});
  REQUIRE(placed.camera);
  CHECK(placed.camera->eye == Eigen::Vector3d(0, 1, 2));
  CHECK(!placed.camera_motion.smooth);
  CHECK(placed.camera_motion.keys[1].time == 3);
}

TEST_CASE("grabs of the command line are known as such") {
  const std::string grab = R"("grabs": [{"at": [0, 0, 0], "translate": [0, 0.1, 0]}])";
  const Scene scene = SceneFile(scene_text("", grab)).open({"--grab at=1,0,0;push=0.1", "--grab at=2,0,0;push=0.1"});
  CHECK(scene.grabs.size() == 3);
  CHECK(scene.option_grabs == 2);
}
