// Materials of regions: the region of a key, and the materials of a model after a change.
#include "sim/model/region_materials.h"

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace fascia;

namespace {

const std::map<int, std::string> kRegions{{1, ""}, {2, "tumour"}, {3, "fat"}, {4, "fat"}, {5, "1"}, {6, "default"}};

MaterialOverride stiffness(double young_modulus) {
  MaterialOverride values;
  values.young_modulus = young_modulus;
  return values;
}

Body body_with(std::vector<std::pair<std::string, MaterialOverride>> entries) {
  Body body;
  body.name = "liver";
  body.region_materials = std::move(entries);
  return body;
}

std::string error_of(const Body& body) {
  try {
    resolve_materials(body, kRegions, "s.json: bodies[0]");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("an entry replaces the values that it gives") {
  Material material;
  material.young_modulus = 1;
  material.damping = 2;
  CHECK(with_override(material, {}) == material);
  MaterialOverride values;
  values.poisson_ratio = 0.1;
  values.density = 5;
  values.model = MaterialModel::mooney_rivlin;
  values.mooney_ratio = 0.7;
  Material expected = material;
  expected.poisson_ratio = 0.1;
  expected.density = 5;
  expected.model = MaterialModel::mooney_rivlin;
  expected.mooney_ratio = 0.7;
  CHECK(with_override(material, values) == expected);
  values.young_modulus = 3;
  values.damping = 4;
  CHECK(with_override(material, values).young_modulus == 3);
  CHECK(with_override(material, values).damping == 4);
}

TEST_CASE("regions of a mesh are those of its tets, with the names of the file") {
  TetMesh mesh;
  mesh.regions = {7, -1, 7, 0};
  mesh.region_names = {{7, "bone"}, {8, "nowhere"}};
  CHECK(regions_of(mesh) == std::map<int, std::string>{{-1, ""}, {0, ""}, {7, "bone"}});
}

TEST_CASE("a key means the regions of its name, else the region of its number") {
  const BodyMaterials result = resolve_materials(
      body_with({{"tumour", stiffness(10)}, {"fat", stiffness(20)}, {"1", stiffness(30)}}), kRegions, "");
  REQUIRE(result.materials.size() == 4);
  CHECK(result.names == std::vector<std::string>{"liver: default", "liver: tumour", "liver: fat", "liver: 1"});
  CHECK(result.material_of(2) == 1);
  CHECK(result.material_of(3) == 2);
  CHECK(result.material_of(4) == 2);
  CHECK(result.material_of(5) == 3);  // is called "1"
  CHECK(result.material_of(1) == 0);
  CHECK(result.material_of(99) == 0);
  CHECK(result.materials[3].young_modulus == 30);
  CHECK(result.materials[3].density == Material{}.density);
  CHECK(resolve_materials(body_with({{"2", stiffness(1)}}), kRegions, "").material_of(2) == 1);
}

TEST_CASE("a key of no region, and a second one of the same, are refused") {
  CHECK(error_of(body_with({{"tumor", {}}})) ==
        "s.json: bodies[0].materials.tumor: the mesh has no region \"tumor\", perhaps \"tumour\"; expected default or "
        "one "
        "of its regions: 1, 2 (tumour), 3 (fat), 4 (fat), 5 (1), 6 (default)");
  CHECK_THAT(error_of(body_with({{"9", {}}})), Catch::Contains("the mesh has no region \"9\""));
  CHECK(error_of(body_with({{"fat", {}}, {"4", {}}})) ==
        "s.json: bodies[0].materials.4: means region 4, as materials.fat does; expected one entry per region");
}

TEST_CASE("the key of a region finds that region alone") {
  const std::map<int, std::string> regions{{1, ""}, {2, "tumour"}, {3, "fat"}, {4, "fat"}, {5, "default"}, {6, "7"}};
  for (const auto& [number, key] : {std::pair{1, "1"}, {2, "tumour"}, {3, "3"}, {4, "4"}, {5, "5"}, {6, "7"}}) {
    CAPTURE(number, key);
    CHECK(key_of_region(regions, number) == key);
    const BodyMaterials found = resolve_materials(body_with({{key, stiffness(1)}}), regions, "");
    for (const auto& [other, name] : regions) CHECK(found.material_of(other) == (other == number ? 1u : 0u));
  }
  CHECK(key_of_region(regions, 42) == "42");
}

TEST_CASE("tets get the regions of the scene by name, by number, or as new ones") {
  TetMesh mesh;
  mesh.tets.resize(8);
  mesh.regions = {0, 0, 1, 1, 1, 7, 7, 7};
  mesh.region_names = {{1, "cortex"}, {4, "nowhere"}};
  Body body;
  body.regions = {{"cortex", {{0, 0}, {5, 5}}}, {"7", {{2, 2}}}, {"tumour", {{3, 4}}}, {"9", {{6, 6}}}};
  assign_regions(body, {{2, "fat"}, {3, "tumour"}}, "s.json: bodies[1]", mesh);
  CHECK(mesh.regions == std::vector<int>{1, 0, 7, 3, 3, 1, 9, 7});  // 2 means fat in another body
  CHECK(mesh.region_names == std::map<int, std::string>{{1, "cortex"}, {3, "tumour"}, {4, "nowhere"}});

  const auto refused = [&](std::vector<TetRegion> regions) {
    body.regions = std::move(regions);
    try {
      assign_regions(body, {}, "s.json: bodies[1]", mesh);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused({{"a", {{0, 1}}}, {"b", {{3, 8}}}}) ==
        "s.json: bodies[1].regions[1].tets: tet 8 does not exist; expected 0 to 7");
  CHECK(refused({{"a", {{0, 3}}}, {"b", {{3, 4}}}}) ==
        "s.json: bodies[1].regions[1].tets: has tet 3, as regions[0] does; expected each tet in one region");
}

TEST_CASE("added and removed materials of a model are assigned to its tets, or nothing changes") {
  Scene scene;
  scene.file = "s.json";
  scene.bodies = {body_with({{"2", stiffness(10)}}), body_with({{"3", stiffness(20)}, {"2", stiffness(30)}})};
  Model model;
  model.file_mesh.regions = {1, 2, 9, 3, 2, 1};  // the third tet of the file is degenerate
  model.tet_source = {0, 1, 3, 4, 5};
  model.tet_material = {0, 0, 0, 0, 0};
  model.bodies.resize(2);
  model.bodies[0].tet_count = 2;
  model.bodies[1].tet_begin = 2;
  model.bodies[1].tet_count = 3;
  for (BodyPart& body : model.bodies) body.regions = kRegions;
  assign_materials(scene, model);
  CHECK(model.tet_material == std::vector<std::uint32_t>{0, 1, 3, 4, 2});
  REQUIRE(model.materials.size() == 5);
  CHECK(model.materials[3].young_modulus == 20);
  CHECK(model.materials[4].young_modulus == 30);
  CHECK(model.material_names[4] == "liver: 2");
  CHECK(model.bodies[0].material_count == 2);
  CHECK(model.bodies[1].material_begin == 2);
  CHECK(model.bodies[1].material_count == 3);

  const Model before = model;
  scene.bodies[0].region_materials.clear();
  scene.bodies[1].region_materials[0].first = "nobody";
  CHECK_THROWS_WITH(assign_materials(scene, model), Catch::StartsWith("s.json: bodies[1].materials.nobody: "));
  CHECK(model.tet_material == before.tet_material);
  CHECK(model.materials == before.materials);
  CHECK(model.bodies[1].material_begin == 2);
  scene.bodies[1].region_materials.clear();
  assign_materials(scene, model);
  CHECK(model.tet_material == std::vector<std::uint32_t>{0, 0, 1, 1, 1});
}
