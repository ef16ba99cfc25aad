// The five verification cases open with the vertices, tets and constrained vertices that their case.json states.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/grab/build_model.h"
#include "sim/model/model.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the verification cases build the models that they describe") {
  const std::string name = GENERATE("01_cantilever_small", "02_cantilever_large", "05_stretch_150",
                                    "09a_affine_compression", "10_dynamic_cantilever");
  CAPTURE(name);
  const std::filesystem::path folder = test_dir() / "reference" / name;
  const auto facts = nlohmann::json::parse(read_file(folder / "case.json"));
  const Scene scene = open_scene(folder / "scene.json");
  const Model model = build_model(scene);
  for (const std::string& note : model.notes) UNSCOPED_INFO(note);
  CHECK(model.notes.empty());
  CHECK(model.rest_positions.size() == facts["vertices"].get<std::size_t>());
  CHECK(model.tets.size() == facts["tets"].get<std::size_t>());
  CHECK(model.file_mesh.tets.size() == model.tets.size());
  CHECK(model.bodies.size() == 1);
  const auto& material = facts["materials"]["1"];
  for (const std::uint32_t m : model.tet_material) {
    REQUIRE(model.materials.at(m).young_modulus == material["E"].get<double>());
    REQUIRE(model.materials.at(m).poisson_ratio == material["nu"].get<double>());
    REQUIRE(model.materials.at(m).density == material["density"].get<double>());
  }
  const std::set<std::uint32_t> fixed(model.fixed.begin(), model.fixed.end());
  std::set<std::uint32_t> stated;
  if (facts.contains("fixed") && facts["fixed"].contains("indices")) {
    stated = facts["fixed"]["indices"].get<std::set<std::uint32_t>>();
  }
  CHECK(fixed == stated);
  double mass = 0;
  for (const double m : lumped_masses(model)) mass += m;
  // The beams and the cube have the volumes of their boxes; the sum of thousands of tets rounds in the 12th digit.
  const char* total = facts.contains("total_mass") ? "total_mass" : "lumped_mass_total";
  CHECK(mass == Approx(facts.at(total).get<double>()).epsilon(1e-12));
}

TEST_CASE("case 05 moves one end by 0.1 m over a second") {
  const Model model = build_model(open_scene(test_dir() / "reference/05_stretch_150/scene.json"));
  REQUIRE(model.motions.size() == 1);
  const Motion& motion = model.motions[0];
  std::ifstream csv(test_dir() / "reference/05_stretch_150/prescribed.csv");
  std::string line;
  std::getline(csv, line);
  std::size_t rows = 0;
  for (; std::getline(csv, line); ++rows) {
    unsigned vertex = 0;
    Eigen::Vector3d target;
    REQUIRE(std::sscanf(line.c_str(), "%u,%lf,%lf,%lf", &vertex, &target[0], &target[1], &target[2]) == 4);
    REQUIRE(rows < motion.vertices.size());
    CHECK(motion.vertices[rows] == vertex);
    // Two roundings of numbers below 1.
    CHECK((motion.position(rows, model.rest_positions[vertex], 1) - target).norm() < 1e-15);
  }
  CHECK(rows == motion.vertices.size());
}
