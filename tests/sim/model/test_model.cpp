// From a scene to the solvers' model: placing, merging, materials, selections, notes.
#include "sim/grab/build_model.h"
#include "sim/model/model.h"

#include <Eigen/Geometry>
#include <numbers>

#include "sim/model/unconstrained_parts.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

/// Two tets on a shared face, regions 1 (unnamed) and 2 ("tumour"), a triangle group "clamp" on vertices 0, 1, 2, and
/// vertex 5 far below, in no tet.
const char* const kTwoTets = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 7 "clamp"
3 2 "tumour"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 1 1 1
6 0 -50 0
$EndNodes
$Elements
3
1 2 2 7 1 1 2 3
2 4 2 1 1 1 2 3 4
3 4 2 2 1 2 3 4 5
$EndElements
)";

/// A scene of one body with `keys` on the mesh above, in one folder.
struct TwoTets : SceneFile {
  explicit TwoTets(const std::string& keys = "", const std::string& mesh = kTwoTets) : SceneFile(scene_text(keys)) {
    write_file(*this / "m.msh", mesh);
  }
  Model build(const std::vector<std::string>& overrides = {}) const { return build_model(open(overrides)); }
  std::string build_error() const {
    return error_of([&] { build(); });
  }
};

using Indices = std::vector<std::uint32_t>;

Indices fixed_by(const std::string& selection) { return TwoTets("\"fixed\": [" + selection + "]").build().fixed; }
std::string selection_error(const std::string& selection) {
  return TwoTets("\"fixed\": [{\"lowest\": 1}, " + selection + "]").build_error();
}

}  // namespace

TEST_CASE("a model has the file's vertices in their order, and its tets") {
  const Model model = TwoTets().build();
  REQUIRE(model.rest_positions.size() == 6);
  CHECK(model.rest_positions[4] == Vector3d(1, 1, 1));
  CHECK(model.rest_positions[5] == Vector3d(0, -50, 0));
  CHECK(model.tets == std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}});
  CHECK(model.tet_source == Indices{0, 1});
  CHECK(model.file_mesh.positions == model.rest_positions);
  CHECK(model.file_mesh.tets.size() == 2);
  CHECK(model.file_mesh.regions == std::vector<int>{1, 2});
  CHECK(model.fixed.empty());
  CHECK(model.motions.empty());
  CHECK(model.initial_velocity == std::vector<Vector3d>(6, Vector3d(0, 0, 0)));
  CHECK(model.gravity == Vector3d(0, -9.81, 0));
  CHECK(model.notes == std::vector<std::string>{"m: 1 vertex in no tet, kept in exports"});
  REQUIRE(model.bodies.size() == 1);
  CHECK(model.bodies[0].name == "m");
  CHECK(model.bodies[0].vertex_count == 6);
  CHECK(model.bodies[0].tet_count == 2);
  CHECK(model.bodies[0].material_count == 1);
}

TEST_CASE("a box is closed and refers to the positions of the file, before the transform") {
  CHECK(fixed_by(R"({"box": [[0, 0, 0], [1, 0, 0]]})") == Indices{0, 1});
  CHECK(fixed_by(R"({"box": [[0.1, 0, 0], [1, 1, 1]]})") == Indices{1, 4});
  const std::string moved = R"("transform": {"scale": 2, "rotate_deg": [0, 0, 90], "translate": [10, 0, 0]}, )";
  CHECK(TwoTets(moved + R"("fixed": [{"box": [[0, 0, 0], [1, 0, 0]]}])").build().fixed == Indices{0, 1});
}

TEST_CASE("a sphere is closed") {
  CHECK(fixed_by(R"({"sphere": {"center": [0, 0, 0], "radius": 1}})") == Indices{0, 1, 2, 3});
  CHECK(fixed_by(R"({"sphere": {"center": [0, 0, 0], "radius": 0.999}})") == Indices{0});
}

TEST_CASE("vertices, groups and several selections unite, ascending and once each") {
  CHECK(fixed_by(R"({"vertices": [4, 0, 4]})") == Indices{0, 4});
  CHECK(fixed_by(R"({"group": "clamp"})") == Indices{0, 1, 2});
  CHECK(fixed_by(R"({"group": "tumour"})") == Indices{1, 2, 3, 4});
  CHECK(fixed_by(R"({"vertices": [3]}, {"group": "clamp"}, {"vertices": [0]})") == Indices{0, 1, 2, 3});
}

TEST_CASE(
    "the lowest share is of the height of the tets, not of stray vertices, or of the vertices if those are more") {
  CHECK(fixed_by(R"({"lowest": 0})") == Indices{0, 1, 3});
  CHECK(fixed_by(R"({"lowest": 0.7})") == Indices{0, 1, 3});  // 3 of 5
  CHECK(fixed_by(R"({"lowest": 0.8})") == Indices{0, 1, 2, 3, 4});
  CHECK(fixed_by(R"({"lowest": 1})") == Indices{0, 1, 2, 3, 4});
}

TEST_CASE("the unit and the axis that points up place the mesh, before the transform") {
  const auto placed = [](const std::string& keys) { return TwoTets(keys).build().rest_positions; };
  const std::vector<Eigen::Vector3d> x = placed("");
  const auto turns = [&](const std::string& up, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& to) {
    CAPTURE(up);
    const std::vector<Eigen::Vector3d> y = placed("\"up\": \"" + up + "\", \"unit\": \"mm\"");
    for (std::size_t v = 0; v < x.size(); ++v) CHECK((y[v] - 1e-3 * to(x[v])).norm() < 1e-18);
  };
  turns("y", [](const Eigen::Vector3d& p) { return p; });
  turns("z", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.z(), -p.y()); });
  turns("x", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.y(), p.x(), p.z()); });
  turns("-x", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.y(), -p.x(), -p.z()); });
  turns("-y", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), -p.y(), -p.z()); });
  turns("-z", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), -p.z(), p.y()); });
  const std::vector<Eigen::Vector3d> moved =
      placed(R"("unit": "in", "up": "z", "transform": {"scale": 2, "translate": [1, 2, 3]})");
  for (std::size_t v = 0; v < x.size(); ++v)
    CHECK((moved[v] - (0.0508 * Eigen::Vector3d(x[v].x(), x[v].z(), -x[v].y()) + Eigen::Vector3d(1, 2, 3))).norm() <
          1e-15);
}

TEST_CASE("an empty selection is an error that states where the vertices are") {
  const std::string expected = "; expected some of the 5 vertices, from (0, 0, 0) to (1, 1, 1)";
  CHECK(selection_error(R"({"box": [[2, 0, 0], [3, 1, 1]]})") ==
        "s.json: bodies[0].fixed[1]: selects nothing" + expected);
  CHECK(selection_error(R"({"sphere": {"center": [5, 5, 5], "radius": 1}})") ==
        "s.json: bodies[0].fixed[1]: selects nothing" + expected);
  CHECK(selection_error(R"({"vertices": [5]})") ==
        "s.json: bodies[0].fixed[1]: selects no vertex of a tet (1 unused)" + expected);
  CHECK(TwoTets(R"("prescribed": [{"select": {"box": [[2, 0, 0], [3, 1, 1]]}}])").build_error() ==
        "s.json: bodies[0].prescribed[0].select: selects nothing" + expected);
}

TEST_CASE("a vertex or a group that the mesh does not have is an error") {
  CHECK(selection_error(R"({"vertices": [0, 6]})") ==
        "s.json: bodies[0].fixed[1]: vertex 6 does not exist; expected 0 to 5");
  CHECK(selection_error(R"({"group": "clam"})") ==
        "s.json: bodies[0].fixed[1]: the mesh has no group \"clam\", perhaps \"clamp\"; expected one of 1, clamp, "
        "tumour");
}

TEST_CASE("regions take their materials by number or by name, over the default") {
  const std::string keys = R"("name": "beam", "materials": {"default": {"young_modulus": 1e4, "density": 900},
                                                            "KEY": {"young_modulus": 1e6}})";
  for (const std::string key : {"2", "tumour"}) {
    CAPTURE(key);
    std::string text = keys;
    text.replace(text.find("KEY"), 3, key);
    const Model model = TwoTets(text).build();
    CHECK(model.tet_material == Indices{0, 1});
    CHECK(model.material_names == std::vector<std::string>{"beam: default", "beam: " + key});
    REQUIRE(model.materials.size() == 2);
    CHECK(model.materials[0] == Material{1e4, 0.3, 900, 0, MaterialModel::signed_st_venant_kirchhoff});
    CHECK(model.materials[1] == Material{1e6, 0.3, 900, 0, MaterialModel::signed_st_venant_kirchhoff});
  }
}

TEST_CASE("regions of the scene replace those of the mesh file, in the solvers and in exports") {
  const Model model = TwoTets(R"("regions": [{"name": "core", "tets": [1]}],
                                 "materials": {"core": {"density": 7}, "tumour": {"density": 8}})")
                          .build();
  CHECK(model.file_mesh.regions == std::vector<int>{1, 3});
  CHECK(model.file_mesh.region_names.at(3) == "core");
  CHECK(model.materials.at(model.tet_material[1]).density == 7);
  CHECK(model.materials.at(model.tet_material[0]).density == Material().density);
  INFO("the region of the file that lost its last tet keeps its material");
  CHECK(model.bodies[0].regions == std::map<int, std::string>{{1, ""}, {2, "tumour"}, {3, "core"}});
  CHECK(model.bodies[0].added_regions == std::set<int>{3});
  CHECK(TwoTets(R"("regions": [{"name": "core", "tets": [[1, 2]]}])")
            .build_error()
            .ends_with("bodies[0].regions[0].tets: tet 2 does not exist; expected 0 to 1"));
}

TEST_CASE("material keys that name no region, or one region twice") {
  CHECK(TwoTets(R"("materials": {"tumor": {}})").build_error() ==
        "s.json: bodies[0].materials.tumor: the mesh has no region \"tumor\", perhaps \"tumour\"; expected default or "
        "one of its regions: 1, 2 (tumour)");
  CHECK(TwoTets(R"("materials": {"7": {}})").build_error() ==
        "s.json: bodies[0].materials.7: the mesh has no region \"7\"; expected default or one of its regions: 1, 2 "
        "(tumour)");
  CHECK(TwoTets(R"("materials": {"clamp": {}})").build_error() ==
        "s.json: bodies[0].materials.clamp: the mesh has no region \"clamp\"; expected default or one of its regions: "
        "1, 2 (tumour)");
  CHECK(TwoTets(R"("materials": {"2": {}, "tumour": {}})").build_error() ==
        "s.json: bodies[0].materials.tumour: means region 2, as materials.2 does; expected one entry per region");
}

TEST_CASE("a transform scales, then rotates about x, y and z, then translates") {
  const Model model =
      TwoTets(R"("transform": {"scale": 2, "rotate_deg": [90, 0, 90], "translate": [10, 20, 30]})").build();
  // (0,0,1) * 2 = (0,0,2); about x by 90: (0,-2,0); about z by 90: (2,0,0). Cosines of 90 degrees are 6e-17.
  CHECK((model.rest_positions[3] - Vector3d(12, 20, 30)).norm() < 1e-14);
  CHECK((model.rest_positions[1] - Vector3d(10, 22, 30)).norm() < 1e-14);
  CHECK((model.rest_positions[2] - Vector3d(10, 20, 32)).norm() < 1e-14);
  const Model about_y = TwoTets(R"("transform": {"rotate_deg": [0, 90, 0]})").build();
  CHECK((about_y.rest_positions[3] - Vector3d(1, 0, 0)).norm() < 1e-14);
}

TEST_CASE("without a transform the positions are the file's to the last bit") {
  const Model model = build_model(open_scene(test_dir() / "reference/01_cantilever_small/scene.json"));
  CHECK(model.rest_positions[0] == Vector3d(0, -0.050000000000000003, -0.050000000000000003));
  CHECK(model.rest_positions[4] == Vector3d(0.40000000000000002, -0.050000000000000003, -0.050000000000000003));
}

TEST_CASE("several bodies are stored one after another, each with its own materials, motions and selections") {
  const SceneFile file(R"({"fascia_scene": 1, "bodies": [
    {"name": "a", "mesh": "m.msh", "fixed": [{"vertices": [0]}], "materials": {"2": {"density": 500}}},
    {"name": "b", "mesh": "m.msh", "transform": {"translate": [100, 0, 0], "scale": 2}, "fixed": [{"group": "clamp"}],
     "prescribed": [{"select": {"vertices": [4]}, "translate": [0, 1, 0]}], "initial_velocity": [0, 0, 3],
     "materials": {"default": {"density": 10}}}]})");
  write_file(file / "m.msh", kTwoTets);
  const Model model = build_model(file.open());
  REQUIRE(model.rest_positions.size() == 12);
  CHECK(model.rest_positions[1] == Vector3d(1, 0, 0));
  CHECK(model.rest_positions[7] == Vector3d(102, 0, 0));
  CHECK(model.tets == std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}, {6, 7, 8, 9}, {7, 8, 9, 10}});
  CHECK(model.tet_source == Indices{0, 1, 2, 3});
  CHECK(model.tet_material == Indices{0, 1, 2, 2});
  CHECK(model.material_names == std::vector<std::string>{"a: default", "a: 2", "b: default"});
  CHECK(model.fixed == Indices{0, 6, 7, 8});
  REQUIRE(model.motions.size() == 1);
  CHECK(model.motions[0].vertices == Indices{10});
  REQUIRE(model.initial_velocity.size() == 12);
  CHECK(model.initial_velocity[4] == Vector3d(0, 0, 0));
  CHECK(model.initial_velocity[8] == Vector3d(0, 0, 0));  // fixed
  CHECK(model.initial_velocity[9] == Vector3d(0, 0, 3));
  CHECK(model.initial_velocity[10] == Vector3d(0, 0, 0));  // prescribed
  CHECK(model.file_mesh.tets == std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}, {6, 7, 8, 9}, {7, 8, 9, 10}});
  CHECK(model.file_mesh.groups.at("clamp") == Indices{0, 1, 2, 6, 7, 8});
  REQUIRE(model.bodies.size() == 2);
  CHECK(model.bodies[1].name == "b");
  CHECK(model.bodies[1].vertex_begin == 6);
  CHECK(model.bodies[1].vertex_count == 6);
  CHECK(model.bodies[1].tet_begin == 2);
  CHECK(model.bodies[1].tet_count == 2);
  CHECK(model.bodies[1].material_begin == 2);
  CHECK(model.bodies[1].material_count == 1);
  // Volumes: 1/6 and 1/3, eight times that for the second body.
  const std::vector<double> masses = lumped_masses(model);
  CHECK(masses[0] == Approx(1000.0 / 24));
  CHECK(masses[1] == Approx(1000.0 / 24 + 500.0 / 12));
  CHECK(masses[4] == Approx(500.0 / 12));
  CHECK(masses[5] == 0);
  CHECK(masses[6] == Approx(10 * 8.0 / 24));
}

TEST_CASE("a vertex that is fixed and prescribed is prescribed") {
  const Model model = TwoTets(R"("fixed": [{"lowest": 1}], "prescribed": [{"select": {"vertices": [2, 4]}}])").build();
  CHECK(model.fixed == Indices{0, 1, 3});
  CHECK(model.held() == std::vector<char>{1, 1, 1, 1, 1, 0});
}

TEST_CASE("initial velocities from a table need every vertex") {
  TwoTets scene(R"("fixed": [{"vertices": [1]}], "initial_velocity": "v.csv")");
  CHECK_THAT(scene.build_error(),
             Catch::Contains("s.json: bodies[0].initial_velocity: v.csv: no such file; looked in "));
  write_file(scene / "v.csv", "index,x,y,z\n0,1,2,3\n1,1,1,1\n");
  CHECK(scene.build_error() ==
        "s.json: bodies[0].initial_velocity: v.csv: misses 4 of 6 vertices, the first is 2; expected a line for every "
        "vertex");
  write_file(scene / "v.csv", "index,x,y,z\n0,1,2,3\n1,1,1,1\n2,0,0,0\n3,0,0,0\n4,0,0,0\n5,0,0,0\n");
  const Model model = scene.build();
  CHECK(model.initial_velocity[0] == Vector3d(1, 2, 3));
  CHECK(model.initial_velocity[1] == Vector3d(0, 0, 0));  // fixed
}

TEST_CASE("repairs and risks are noted") {
  std::string mesh = kTwoTets;
  const std::string elements = mesh.substr(mesh.find("$Elements"));
  mesh.resize(mesh.find("$Elements"));
  mesh +=
      "$Elements\n6\n1 4 2 1 1 2 1 3 4\n2 4 2 2 1 2 3 4 5\n3 4 2 1 1 1 2 3 3\n4 4 2 1 1 1 2 3 1\n"
      "5 4 2 2 1 5 2 3 4\n6 4 2 2 1 4 2 3 5\n$EndElements\n";
  const Model model = TwoTets(R"("name": "liver", "materials": {"default": {"poisson_ratio": 0.47},
                                                                "2": {"poisson_ratio": 0.45}})",
                              mesh)
                          .build();
  CHECK(model.notes == std::vector<std::string>{"liver: 1 tet flipped in the file, reoriented (tet 0)",
                                                "liver: 2 tets degenerate, left out of the physics (first: tet 2)",
                                                "liver: 2 tets duplicated, left out of the physics (first: tet 4)",
                                                "liver: 1 vertex in no tet, kept in exports",
                                                "liver: default: Poisson's ratio 0.47; linear tets lock above 0.45: "
                                                "expect too little motion on a coarse mesh, or use --set "
                                                "elements=quadratic"});
  CHECK(model.tets.size() == 2);
  CHECK(model.tet_source == Indices{0, 1});
  CHECK(model.tet_material == Indices{0, 1});
  CHECK(model.file_mesh.tets.size() == 6);
  for (const Tet& tet : model.tets) {
    const auto& x = model.rest_positions;
    CHECK(signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) > 0);
  }
}

TEST_CASE("a mesh of degenerate tets only cannot be simulated") {
  std::string mesh = kTwoTets;
  mesh.resize(mesh.find("$Elements"));
  mesh += "$Elements\n1\n1 4 2 1 1 1 2 3 3\n$EndElements\n";
  CHECK(TwoTets("", mesh).build_error() ==
        "s.json: bodies[0].mesh: m.msh: has no tet higher than 1e-7 of its longest edge (1 degenerate); expected at "
        "least one");
}

TEST_CASE("a missing or unreadable mesh is reported with its scene key") {
  const SceneFile scene(scene_text());
  const auto build_error = [&] { return scene.error_of([&] { build_model(scene.open()); }); };
  CHECK_THAT(build_error(), Catch::Contains("s.json: bodies[0].mesh: m.msh: no such file; looked in "));
  write_file(scene / "m.msh", "rubbish");
  CHECK(build_error().find("s.json: bodies[0].mesh: m.msh: is not a mesh format") == 0);
  const SceneFile alone("rubbish", "alone.msh");
  CHECK(alone.error_of([&] { build_model(alone.open()); }).find("alone.msh: is not a mesh format") == 0);
}

TEST_CASE("files of surfaces and tools are reported with their scene keys") {
  const std::string surface = R"("surface": "o.obj")", tool = R"("instruments": [{"name": "p", "shape":
      {"mesh": {"file": "o.obj"}}}])";
  const auto error = [](const std::string& keys, const std::string& top, const std::string& obj) {
    const SceneFile scene(scene_text(keys, top));
    write_file(scene / "m.msh", kTwoTets);
    write_file(scene / "o.obj", obj);
    return scene.error_of([&] { build_model(scene.open()); });
  };
  const std::string at_tool = "s.json: instruments[0].shape.mesh.file: o.obj";
  CHECK(error(surface, "", "f 1 2 3").find("s.json: bodies[0].surface: o.obj:1: ") == 0);
  CHECK(error("", tool, "f 1 2 3").find(at_tool + ":1: ") == 0);
  CHECK(error("", tool, "").find(at_tool + ": has no faces") == 0);
  CHECK(error("", tool, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n") ==
        at_tool + ": is open: 3 edges of one triangle only; expected a closed surface");
}

TEST_CASE("bodies too small or too large for float32 are refused by their size") {
  const auto error = [](const std::string& scale) {
    return TwoTets(R"("name": "a", "transform": {"scale": )" + scale + "}").build_error();
  };
  const std::string expected =
      " m wide with its unit and transform; expected 1e-07 to 1e+09 m: unit or transform.scale give the mesh another "
      "size";
  CHECK(error("1e-9") == "s.json: bodies[0].mesh: a is 1e-09" + expected);
  CHECK(TwoTets(R"("unit": "um", "transform": {"scale": 0.2})").build().tets.size() == 2);
  CHECK(TwoTets(R"("transform": {"scale": 1e8})").build().tets.size() == 2);
}

TEST_CASE("the hash of a mesh depends on every bit of positions and every index") {
  TetMesh mesh;
  CHECK(mesh_hash(mesh) == 0xcbf29ce484222325);  // FNV-1a of no bytes
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  const std::uint64_t hash = mesh_hash(mesh);
  TetMesh other = mesh;
  CHECK(mesh_hash(other) == hash);
  other.positions[3].z() = std::nextafter(1.0, 2.0);
  CHECK(mesh_hash(other) != hash);
  other = mesh;
  other.tets = {{0, 2, 1, 3}};
  CHECK(mesh_hash(other) != hash);
}

TEST_CASE("components that fall away from a supported model are noted") {
  std::string apart = kTwoTets;  // the second tet has separate vertices at the face
  apart.replace(apart.find("$Nodes\n6"), 8, "$Nodes\n9");
  apart.insert(apart.find("$EndNodes"), "7 5 0 0\n8 5 1 0\n9 5 0 1\n");
  apart.replace(apart.find("3 4 2 2 1 2 3 4 5"), 17, "3 4 2 2 1 7 8 9 5");
  const auto note_of = [&](const std::string& keys, const std::vector<std::string>& overrides = {}) {
    return note_of_unconstrained_parts(TwoTets(keys, apart).build(overrides));
  };
  const std::string fixed = R"("name": "liver", "fixed": [{"vertices": [0]}])";
  const Model model = TwoTets(fixed, apart).build();
  const UnconstrainedParts unconstrained = unconstrained_parts(model, model.held());
  CHECK(unconstrained.parts == 1);
  CHECK(unconstrained.vertices == 4);
  CHECK(unconstrained.held_parts == 1);
  REQUIRE(!model.notes.empty());
  CHECK(model.notes.back() ==
        "1 component of 4 vertices in all is unconstrained and will fall (vertex 4 of liver): no vertex is fixed or "
        "prescribed");
  CHECK(note_of(fixed, {"gravity=[0,0,0]"}).empty());
  CHECK(note_of("").empty());  // the whole model falls
  CHECK(note_of(R"("fixed": [{"vertices": [0, 4]}])").empty());
  CHECK(note_of(R"("fixed": [{"vertices": [0]}], "prescribed": [{"select": {"vertices": [7]}}])").empty());
  CHECK(note_of_unconstrained_parts(TwoTets(fixed).build()).empty());  // fixed at the face between the two
}
