// Files of scenes that were moved, changed or carried: found again, refused or reported, never confused with others.
// Covers: known_file, scene_paths, scene_read_files, sim/model/file_reader
#include <nlohmann/json.hpp>

#include "base/data_folder.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/replay/replay.h"
#include "sim/scene/scene_carry.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

using Catch::Contains;

// A cube whose corners have colors by material, with two triangles per side.
std::string obj_cube(const std::string& library) {
  std::string text = "mtllib " + library + "\n";
  for (int i = 0; i < 8; ++i)
    text += "v " + std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " + std::to_string(i >> 2) + "\n";
  return text + "usemtl red\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

std::string library(double red) { return "newmtl red\nKd " + std::to_string(red) + " 0 0\n"; }

/// A folder with a scene that refers to a file of every kind.
struct Project {
  TemporaryFolder folder;
  Project() {
    for (const char* name : {"scenes", "meshes", "more", "lib"}) fs::create_directory(folder / name);
    write_mesh(folder / "meshes/body.msh", make_box(2, 1, 1, {0.2, 0.1, 0.1}));
    write_mesh(folder / "more/body.msh", make_box(3, 1, 1, {0.3, 0.1, 0.1}));
    write_mesh(folder / "meshes/pair.node", make_box(1, 2, 1, {0.1, 0.2, 0.1}));
    write_file(folder / "meshes/skin.obj", obj_cube("skin.mtl"));
    write_file(folder / "meshes/skin.mtl", library(1));
    write_file(folder / "more/skin.obj", obj_cube("../lib/skin.mtl"));
    write_file(folder / "lib/skin.mtl", library(0.5));
    std::string velocity;
    for (int v = 0; v < 12; ++v) velocity += std::to_string(v) + ",0,0,1\n";
    write_file(folder / "scenes/velocity.csv", velocity);
    write_file(folder / "scenes/targets.csv", "0,0,0,0\n1,0.1,0,0\n");
    write_file(scene_file(), R"({"fascia_scene": 1, "bodies": [
      {"name": "a", "mesh": "../meshes/body.msh", "surface": "../meshes/skin.obj", "initial_velocity": "velocity.csv"},
      {"name": "b", "mesh": "../more/body.msh", "surface": "../more/skin.obj", "prescribed": [{"targets": "targets.csv"}]},
      {"name": "c", "mesh": "../meshes/pair.ele", "fixed": [{"lowest": 0.1}]},
      {"name": "d", "mesh": "../more/skin.obj", "resolution": 4, "fixed": [{"lowest": 0.1}]}]})");
  }
  fs::path scene_file() const { return folder / "scenes/all.json"; }
};

void check_same(const Model& a, const Model& b) {
  CHECK(mesh_hash(a.file_mesh) == mesh_hash(b.file_mesh));
  CHECK(a.initial_velocity == b.initial_velocity);
  REQUIRE(a.motions.size() == b.motions.size());
  for (std::size_t m = 0; m < a.motions.size(); ++m) CHECK(a.motions[m].targets == b.motions[m].targets);
  REQUIRE(a.surfaces.size() == b.surfaces.size());
  for (std::size_t s = 0; s < a.surfaces.size(); ++s) {
    CHECK(a.surfaces[s].positions == b.surfaces[s].positions);
    CHECK(a.surfaces[s].colors == b.surfaces[s].colors);
  }
}

/// A scene of one mesh, with m.msh beside it and known data of that file.
struct Known {
  TemporaryFolder folder;
  Known() {
    write_mesh(folder / "m.msh", make_box(2, 1, 1, {0.2, 0.1, 0.1}));
    write_file(file(), scene_text(R"("fixed": [{"lowest": 0.1}])"));
    const Scene scene = open_scene(file());
    write_file(file(), scene_to_json(with_known_files(scene, build_model(scene).files), folder.path()));
  }
  fs::path file() const { return folder / "s.json"; }
  void move_mesh(const std::string& place) const {
    fs::create_directories((folder / place).parent_path());
    fs::rename(folder / "m.msh", folder / place);
  }
};

std::string error_of_building(const fs::path& scene) {
  try {
    build_model(open_scene(scene));
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  FAIL_CHECK("no error");
  return "";
}

}  // namespace

TEST_CASE("a missing file is named with its scene and key") {
  const SceneFile bare(scene_text());
  CHECK_THAT(bare.error_of([&] { build_model(bare.open()); }),
             Contains("s.json: bodies[0].mesh: m.msh: no such file; looked in "));
  const Project project;
  const std::string scene = project.scene_file().string();
  struct Row {
    const char *file, *key, *path;
  };
  for (const Row& row : {Row{"more/body.msh", "bodies[1].mesh", "../more/body.msh"},
                         Row{"meshes/skin.obj", "bodies[0].surface", "../meshes/skin.obj"},
                         Row{"scenes/velocity.csv", "bodies[0].initial_velocity", "velocity.csv"},
                         Row{"scenes/targets.csv", "bodies[1].prescribed[0].targets", "targets.csv"}}) {
    const fs::path file = project.folder / row.file, away = project.folder / "away";
    fs::rename(file, away);
    CHECK_THAT(error_of_building(scene),
               Contains(scene + ": " + row.key + ": " + row.path + ": no such file; looked in "));
    fs::rename(away, file);
  }
  fs::remove(project.folder / "more/body.msh");
  fs::create_directory(project.folder / "more/body.msh");
  CHECK_THAT(error_of_building(scene), Contains(scene + ": bodies[1].mesh: ") && Contains("is a directory"));
}

TEST_CASE("a moved mesh is found beside the scene by its name, with a note") {
  const TemporaryFolder folder;
  write_mesh(folder / "m.msh", make_box(2, 1, 1, {0.2, 0.1, 0.1}));
  for (const char* path : {"../meshes/m.msh", "/nowhere/m.msh", "assets:meshes/m.msh"}) {
    CAPTURE(path);
    write_file(folder / "s.json", std::string(R"({"fascia_scene": 1, "bodies": [{"mesh": ")") + path +
                                      R"(", "fixed": [{"lowest": 0.1}]}]})");
    const Scene scene = open_scene(folder / "s.json");
    CHECK(scene.bodies[0].mesh == "m.msh");
    const Model model = build_model(scene);
    CHECK(model.tets.size() == 12);
    REQUIRE(model.notes.size() == 1);
    CHECK_THAT(model.notes[0],
               Contains("s.json: bodies[0].mesh: " + std::string(path) + ": no such file; read ") && Contains("m.msh"));
  }
}

TEST_CASE("a moved mesh is found by its content, and no other file is used instead") {
  const Known known;
  CHECK(build_model(open_scene(known.file())).notes.empty());
  SECTION("renamed") {
    known.move_mesh("renamed.msh");
    const Model model = build_model(open_scene(known.file()));
    REQUIRE(model.notes.size() == 1);
    CHECK_THAT(model.notes[0], Contains("m.msh: no such file; read ") && Contains("renamed.msh"));
    CHECK(model.tets.size() == 12);
  }
  SECTION("with another file of its name beside the scene") {
    Scene scene = open_scene(known.file());
    write_mesh(known.folder / "m.msh", make_box(4, 1, 1, {0.2, 0.1, 0.1}));
    scene.bodies[0].mesh = scene.files[0].path = "gone/m.msh";
    write_file(known.file(), scene_to_json(scene, known.folder.path()));
    CHECK_THAT(error_of_building(known.file()),
               Contains("gone/m.msh: no such file; looked in ") && Contains("(whose m.msh is another file)"));
    INFO("and the right one is found behind it");
    write_mesh(known.folder / "other_name.msh", make_box(2, 1, 1, {0.2, 0.1, 0.1}));
    CHECK(build_model(open_scene(known.file())).tets.size() == 12);
  }
  SECTION("changed in its place") {
    write_mesh(known.folder / "m.msh", make_box(4, 1, 1, {0.2, 0.1, 0.1}));
    const Model model = build_model(open_scene(known.file()));
    REQUIRE(model.notes.size() == 1);
    CHECK_THAT(model.notes[0], Contains("m.msh: has changed since ") && Contains("s.json was written"));
  }
}

TEST_CASE("a scene carries its files, of every kind, into an empty folder") {
  const Project project;
  const Scene scene = open_scene(project.scene_file());
  Model model = build_model(scene);
  const Scene whole = self_contained(scene, model.files);
  const TemporaryFolder elsewhere;
  write_file(elsewhere / "moved.json", scene_to_json(whole, elsewhere.path()));
  Replay replay{whole, std::nullopt, {{3, GravityInput{{0, 0, 0}}}}, 5};
  write_replay(elsewhere / "moved.fascia", replay);
  fs::remove_all(project.folder / "meshes");
  fs::remove_all(project.folder / "more");
  fs::remove_all(project.folder / "lib");
  fs::remove_all(project.folder / "scenes");

  const Scene moved = open_scene(elsewhere / "moved.json");
  check_same(build_model(moved), model);
  CHECK(build_model(moved).notes == model.notes);
  const Replay read = read_replay(elsewhere / "moved.fascia");
  check_same(build_model(read.scene), model);
  CHECK(read.inputs == replay.inputs);
  CHECK(moved.files.size() == 10);  // 2 .msh, .ele and .node, 2 .obj with their .mtl, 2 .csv

  INFO("it stays so when it is saved again, and is the same text");
  Model again = build_model(moved);
  CHECK(scene_to_json(with_known_files(moved, again.files), elsewhere.path()) == read_file(elsewhere / "moved.json"));
  CHECK(scene_to_json(self_contained(moved, again.files), elsewhere.path()) == read_file(elsewhere / "moved.json"));
  CHECK(parameters_to_json(moved, elsewhere.path()).find("deflated") == std::string::npos);

  INFO("and another mesh takes the place of the carried one");
  write_mesh(elsewhere / "own.msh", make_box(5, 1, 1, {0.2, 0.1, 0.1}));
  const Scene other = open_scene(elsewhere / "moved.json", {"bodies.2.mesh=own.msh"});
  CHECK(build_model(other).bodies[2].tet_count == 30);
}

TEST_CASE("a file that was needed for one scene is not in memory for the next save without it") {
  const Known known;
  const Scene scene = open_scene(known.file());
  Model model = build_model(scene);
  CHECK(scene_to_json(self_contained(scene, model.files), "").find("deflated") != std::string::npos);
  CHECK(scene_to_json(with_known_files(scene, model.files), "").find("deflated") == std::string::npos);
}

TEST_CASE("a changed file is not carried under the old one's name") {
  const Known known;
  const Scene scene = open_scene(known.file());
  Model model = build_model(scene);
  write_mesh(known.folder / "m.msh", make_box(4, 1, 1, {0.2, 0.1, 0.1}));
  CHECK_THROWS_WITH(self_contained(scene, model.files), Contains("m.msh: has changed since it was opened; "));
  CHECK_FALSE(self_contained_if_possible(scene, model.files).carries("m.msh"));
}

TEST_CASE("a library without a material is not carried: an .obj may name any file") {
  const TemporaryFolder folder;
  write_file(folder / "secret.txt", "nobody's business");
  write_file(folder / "s.obj", obj_cube("secret.txt"));
  const Scene scene = open_scene(folder / "s.obj", {"resolution=4"});
  Model model = build_model(scene);
  const Scene whole = self_contained(scene, model.files);
  REQUIRE(whole.files.size() == 1);
  CHECK(whole.files[0].path == "s.obj");
}

TEST_CASE("damaged or implausible contents are refused in one line") {
  const Known known;
  const Scene scene = open_scene(known.file());
  Model model = build_model(scene);
  const auto document = nlohmann::json::parse(scene_to_json(self_contained(scene, model.files), ""));
  const TemporaryFolder folder;
  const auto error_with = [&](const std::string& key, const nlohmann::json& value) {
    auto changed = document;
    changed["files"][0][key] = value;
    write_file(folder / "s.json", changed.dump());
    return error_of_building(folder / "s.json");
  };
  const std::string content = document["files"][0]["deflated"];
  const std::uint64_t size = document["files"][0]["size"];
  CHECK_THAT(error_with("deflated", "%%%"), Contains("s.json: files[0].deflated: is \"%%%\"; expected base64"));
  CHECK_THAT(error_with("deflated", ""), Contains("files[0].deflated"));
  CHECK_THAT(error_with("deflated", 3), Contains("files[0].deflated"));
  CHECK_THAT(error_with("deflated", content.substr(0, content.size() / 8 * 4)),
             Contains("files: m.msh: its content is damaged"));
  CHECK_THAT(error_with("deflated", content + "AAAA"), Contains("its content is damaged") || Contains("base64"));
  CHECK_THAT(error_with("hash", "0000000000000000"),
             Contains("files: m.msh: its content is damaged; expected " + std::to_string(size) + " bytes"));
  CHECK_THAT(error_with("hash", "abc"), Contains("files[0].hash") && Contains("16 hexadecimal digits"));
  CHECK_THAT(error_with("size", size - 1), Contains("its content is damaged"));
  CHECK_THAT(error_with("size", size + 1), Contains("its content is damaged"));
  CHECK_THAT(error_with("size", 1000000000),
             Contains("files[0].size: is 1000000000; expected a size that can come out of "));
  CHECK_THAT(error_with("size", 1e14),
             Contains("files[0].size: is 100000000000000.0; expected 0 to 1.07374e+09 bytes"));
  CHECK_THAT(error_with("size", -1), Contains("files[0].size"));
  CHECK_THAT(error_with("size", 0.5), Contains("files[0].size"));
  CHECK_THAT(error_with("extra", 1), Contains("files[0].extra: unknown key"));
}

TEST_CASE("a saved scene refers to shipped files by a path that is valid everywhere") {
  const fs::path liver = source_dir() / "assets/scenes/cube.json";
  const Scene shipped = open_scene(liver);
  const TemporaryFolder elsewhere;
  write_file(elsewhere / "saved.json", scene_to_json(shipped, elsewhere.path()));
  const Scene saved = open_scene(elsewhere / "saved.json");
  CHECK(saved.bodies[0].mesh == "assets:meshes/cube.msh");
  CHECK(fs::equivalent(saved.resolve(saved.bodies[0].mesh), asset_folder() / "meshes/cube.msh"));
  CHECK(mesh_hash(build_model(saved).file_mesh) == mesh_hash(build_model(shipped).file_mesh));

  INFO("a mesh of the assets opened alone; a scene of an older version");
  const Scene alone = open_scene(source_dir() / "assets/meshes/cube.msh");
  CHECK(scene_to_json(alone, elsewhere.path()).find("\"assets:meshes/cube.msh\"") != std::string::npos);
  const std::string old_path = fs::relative(source_dir() / "assets/meshes/cube.msh", elsewhere.path()).string();
  write_file(elsewhere / "old.json",
             R"({"fascia_scene": 1, "bodies": [{"mesh": ")" + old_path + R"(", "fixed": [{"lowest": 0.1}]}]})");
  const Scene old = open_scene(elsewhere / "old.json");
  CHECK(old.bodies[0].mesh == old_path);
  CHECK(build_model(old).notes.empty());
  CHECK(scene_to_json(old, elsewhere.path()).find("\"assets:meshes/cube.msh\"") != std::string::npos);

  INFO("and one that was moved");
  write_file(
      elsewhere / "moved.json",
      R"({"fascia_scene": 1, "bodies": [{"mesh": "../../gone/assets/meshes/cube.msh", "fixed": [{"lowest": 0.1}]}]})");
  const Scene moved = open_scene(elsewhere / "moved.json");
  CHECK(moved.bodies[0].mesh == "assets:meshes/cube.msh");
  CHECK(moved.notes.size() == 1);

  INFO("a shipped scene itself stays as it is");
  CHECK(scene_to_json(shipped, liver.parent_path()).find("\"../meshes/cube.msh\"") != std::string::npos);
}

TEST_CASE("a saved scene has paths below its folder, or absolute ones") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "project/meshes");
  fs::create_directories(folder / "project/deep");
  write_mesh(folder / "project/meshes/m.msh", make_box(2, 1, 1, {0.2, 0.1, 0.1}));
  write_file(folder / "project/deep/s.json", R"({"fascia_scene": 1, "bodies": [{"mesh": "../meshes/m.msh"}]})");
  const Scene scene = open_scene(folder / "project/deep/s.json");
  const auto path_in = [&](const std::string& place) {
    fs::create_directories(folder / place);
    return nlohmann::json::parse(scene_to_json(scene, folder / place))["bodies"][0]["mesh"].get<std::string>();
  };
  CHECK(path_in("project") == "meshes/m.msh");
  CHECK(path_in("project/meshes") == "m.msh");
  CHECK(path_in("project/deep") == "../meshes/m.msh");  // unchanged
  CHECK(path_in("elsewhere") == fs::canonical(folder / "project/meshes/m.msh").string());
  CHECK(path_in("project/meshes2") == fs::canonical(folder / "project/meshes/m.msh").string());
}
