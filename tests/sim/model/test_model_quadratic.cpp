// Bodies of quadratic tets: their mid-edge vertices, constraints and velocities, beside linear bodies.
// Covers: unconstrained_parts, model_sums
#include <algorithm>
#include <set>

#include "sim/grab/build_model.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mid_edges.h"
#include "sim/model/model.h"
#include "sim/model/unconstrained_parts.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

/// Two tets on a shared face, the second one inside out, and a flat third one.
TetMesh tets() {
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0.5, 0.5, 0}};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 4, 3}, {0, 1, 2, 5}};
  mesh.regions = {1, 1, 1};
  return mesh;
}

/// Two bodies of the mesh, "a" and "b", with `keys` of the second one.
struct TwoBodies : SceneFile {
  explicit TwoBodies(const std::string& keys, const std::string& keys_of_a = "")
      : SceneFile(R"({"fascia_scene": 1, "bodies": [{"name": "a", "mesh": "m.msh")" + comma(keys_of_a) +
                  R"(}, {"name": "b", "mesh": "m.msh", "transform": {"translate": [0, 5, 0]})" + comma(keys) + "}]}") {
    write_mesh(*this / "m.msh", tets());
  }
  static std::string comma(const std::string& keys) { return keys.empty() ? "" : ", " + keys; }
  Model build(const std::vector<std::string>& overrides = {}) const { return build_model(open(overrides)); }
};

constexpr std::uint32_t kCorners = 6, kMiddles = 9;  // of one body

std::uint32_t middle_of(const Model& model, std::uint32_t a, std::uint32_t b) {
  for (const MidEdge& edge : mid_edges_of(model.file_mesh))
    if (std::minmax(edge.a, edge.b) == std::minmax(a, b)) return edge.vertex;
  FAIL("no edge from " << a << " to " << b);
  return 0;
}

}  // namespace

TEST_CASE("a body of quadratic tets beside a linear one has a vertex in the middle of every edge", "[quadratic]") {
  const bool first = GENERATE(false, true);
  const std::string key = R"("elements": "quadratic")";
  const Model model = first ? TwoBodies("", key).build() : TwoBodies(key).build();
  const std::size_t quadratic = first ? 0 : 1;
  REQUIRE(model.rest_positions.size() == 2 * kCorners + kMiddles);
  REQUIRE(model.tets.size() == 4);
  REQUIRE(model.mid_edges.size() == 4);
  REQUIRE(model.file_mesh.mid_edges.size() == 6);
  CHECK(model.file_mesh.positions.size() == model.rest_positions.size());
  CHECK(model.initial_velocity.size() == model.rest_positions.size());
  CHECK(model.bodies[quadratic].vertex_count == kCorners + kMiddles);
  CHECK(model.bodies[1 - quadratic].vertex_count == kCorners);
  CHECK(model.bodies[1].vertex_begin == model.bodies[0].vertex_count);
  for (std::size_t t = 0; t < 4; ++t) {
    CAPTURE(t);
    CHECK(model.is_quadratic(t) == (t / 2 == quadratic));
    CHECK(model.element(t).size() == (model.is_quadratic(t) ? 10 : 4));
    if (!model.is_quadratic(t)) continue;
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [a, b] = kMidEdgeCorners[m];
      const auto& x = model.rest_positions;
      CHECK((x[model.element(t)[4 + m]] - 0.5 * (x[model.tets[t][a]] + x[model.tets[t][b]])).norm() < 1e-14);
    }
  }
  // The flat tet is left out, and stays linear in exports.
  CHECK(model.file_mesh.mid_edges[3 * quadratic + 2] == kNoMidEdges);
  CHECK(!model.file_mesh.mid_edges.empty());
  for (std::size_t t = 0; t < 4; ++t)
    CHECK(std::set<std::uint32_t>(model.mid_edges[t].begin(), model.mid_edges[t].end()) ==
          std::set<std::uint32_t>(model.file_mesh.mid_edges[model.tet_source[t]].begin(),
                                  model.file_mesh.mid_edges[model.tet_source[t]].end()));
}

TEST_CASE("linear bodies have no mid-edge vertices", "[quadratic]") {
  const Model model = TwoBodies("").build();
  CHECK(!model.has_quadratic());
  CHECK(model.file_mesh.mid_edges.empty());
  CHECK(model.rest_positions.size() == 2 * kCorners);
  CHECK(TwoBodies("").build({"bodies.1.elements=quadratic"}).has_quadratic());
  CHECK(mesh_hash(TwoBodies("").build({"elements=quadratic"}).file_mesh) != mesh_hash(model.file_mesh));
}

TEST_CASE("a middle is fixed if both ends of its edge are", "[quadratic]") {
  const Model model = TwoBodies(R"("elements": "quadratic", "fixed": [{"vertices": [1, 2, 5]}])").build();
  const std::uint32_t b = kCorners;
  CHECK(model.fixed == std::vector<std::uint32_t>{b + 1, b + 2, b + 5, middle_of(model, b + 1, b + 2)});
  CHECK(std::is_sorted(model.fixed.begin(), model.fixed.end()));
}

TEST_CASE("middles move with edges of one motion, and are free between two", "[quadratic]") {
  const TwoBodies scene(R"("elements": "quadratic", "prescribed": [
    {"select": {"vertices": [0, 1]}, "translate": [0, 1, 0], "duration": 1},
    {"targets": "t.csv", "duration": 1}])");
  write_file(scene / "t.csv", "2,0,6,0.5\n3,0,5,2\n");
  const Model model = scene.build();
  const std::uint32_t b = kCorners;
  REQUIRE(model.motions.size() == 2);
  CHECK(model.motions[0].vertices == std::vector<std::uint32_t>{b, b + 1, middle_of(model, b, b + 1)});
  CHECK(model.motions[0].position(2, model.rest_positions[middle_of(model, b, b + 1)], 1) == Vector3d(0.5, 6, 0));
  CHECK(model.motions[1].vertices == std::vector<std::uint32_t>{b + 2, b + 3, middle_of(model, b + 2, b + 3)});
  REQUIRE(model.motions[1].targets.size() == 3);
  CHECK(model.motions[1].targets[2] == Vector3d(0, 5.5, 1.25));
  const std::vector<char> held = model.held();
  CHECK(!held[middle_of(model, b + 1, b + 2)]);
  CHECK(std::count(held.begin(), held.end(), 1) == 6);
}

TEST_CASE("middles start with the mean velocity of the ends, zero where they are held", "[quadratic]") {
  const TwoBodies scene(R"("elements": "quadratic", "fixed": [{"vertices": [0, 1]}], "initial_velocity": "v.csv")");
  write_file(scene / "v.csv", "0,9,9,9\n1,9,9,9\n2,2,0,0\n3,0,4,0\n4,0,0,6\n5,0,0,0\n");
  const Model model = scene.build();
  const auto velocity = [&](std::uint32_t a, std::uint32_t b) {
    return model.initial_velocity[middle_of(model, kCorners + a, kCorners + b)];
  };
  CHECK(velocity(0, 1) == Vector3d(0, 0, 0));
  CHECK(velocity(1, 2) == Vector3d(1, 0, 0));
  CHECK(velocity(2, 3) == Vector3d(1, 2, 0));
  CHECK(velocity(3, 4) == Vector3d(0, 2, 3));
}

TEST_CASE("a middle supports its part as a corner does", "[quadratic]") {
  const Model model = TwoBodies(R"("elements": "quadratic")").build({"fixed=[{\"vertices\": [0]}]"});
  const UnconstrainedParts parts = unconstrained_parts(model, model.held());
  CHECK(parts.parts == 1);
  CHECK(parts.held_parts == 1);
  CHECK(parts.vertices == 5 + kMiddles);  // all but the vertex of the flat tet
}

TEST_CASE("elements are read strictly, saved, and spared the note on locking", "[quadratic]") {
  const TwoBodies scene(R"("elements": "quadratic", "materials": {"default": {"poisson_ratio": 0.49}})");
  const Scene read = scene.open();
  CHECK(read.bodies[0].elements == ElementOrder::linear);
  CHECK(read.bodies[1].elements == ElementOrder::quadratic);
  const Scene again = read_scene_content(read.file, scene_to_json(read, scene.path().parent_path()));
  CHECK(again.bodies == read.bodies);
  const auto locks = [](const std::string& note) { return note.find("lock") != std::string::npos; };
  const auto notes = [&](const std::vector<std::string>& overrides) {
    const std::vector<std::string> all = scene.build(overrides).notes;
    return std::count_if(all.begin(), all.end(), locks);
  };
  CHECK(notes({}) == 0);
  CHECK(notes({"bodies.1.elements=linear"}) == 1);
  CHECK_THROWS_WITH(scene.open({"elements=cubic"}), "--set elements: is \"cubic\"; expected one of linear, quadratic");
}

TEST_CASE("the ten nodes of a file are used, its curved edges straightened", "[quadratic]") {
  TetMesh mesh = tets();
  mesh.tets.resize(1);
  mesh.regions.resize(1);
  mesh.positions.resize(5);
  add_mid_edges(mesh, {0});
  const std::uint32_t curved = mesh.mid_edges[0][1];  // between corners 1 and 2
  const Vector3d middle = mesh.positions[curved];
  mesh.positions[curved] += Vector3d(0.02, 0.02, 0);
  const TwoBodies scene(R"("elements": "quadratic", "fixed": [{"box": [[-1, -1, -1], [2, 2, 0.4]]}])");
  write_mesh(scene / "m.msh", mesh);
  const Model model = scene.build();
  const std::size_t linear = 11, b = model.bodies[1].vertex_begin;
  CHECK(b == linear);
  CHECK(model.rest_positions.size() == 2 * linear);  // none was added
  CHECK(model.mid_edges[1][1] == b + curved);
  CHECK((model.rest_positions[b + curved] - Vector3d(middle + Vector3d(0, 5, 0))).norm() < 1e-14);
  CHECK((model.rest_positions[curved] - mesh.positions[curved]).norm() <
        1e-14);  // the linear body has what the file has
  const auto has = [&](const std::string& note) {
    return std::find(model.notes.begin(), model.notes.end(), note) != model.notes.end();
  };
  CAPTURE(model.notes);
  CHECK(has("a: " + std::string(kHigherOrderNote)));
  CHECK(!has("b: " + std::string(kHigherOrderNote)));
  CHECK(has("b: 1 curved edge straightened"));
  CHECK(has("b: 1 vertex in no tet, kept in exports"));
  // The box holds corners 0, 1 and 2: also the middles between them, not those towards corner 3.
  std::vector<std::uint32_t> expected;
  for (const std::uint32_t v : {0u, 1u, 2u, mesh.mid_edges[0][0], mesh.mid_edges[0][1], mesh.mid_edges[0][2]})
    expected.push_back(static_cast<std::uint32_t>(b) + v);
  std::sort(expected.begin(), expected.end());
  CHECK(model.fixed == expected);
}
