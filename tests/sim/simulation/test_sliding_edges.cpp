// Tools with sharp edges that slide over tissue drag it with their friction, and do not hook into it.
// Covers: simulation
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// A slab of 16 x 5 x 10 cm, held from below, with cells of 6.7 mm. The tool, 5 or 4 cm wide, is pressed in by 3 mm and
// goes 4 cm along it.
Scene slide(const nlohmann::json& shape) {
  nlohmann::json scene{{"fascia_scene", 1}, {"gravity", {0, 0, 0}}};
  nlohmann::json& body = scene["bodies"][0];
  body = {{"name", "slab"}, {"mesh", "slab"}};
  body["materials"]["default"] = {{"young_modulus", 1e4}, {"poisson_ratio", 0.3}, {"density", 1000}, {"damping", 0.01}};
  body["fixed"][0]["box"] = {{-1, -1, -1}, {1, 1e-6, 1}};
  nlohmann::json& tool = scene["instruments"][0];
  tool = {{"name", "tool"}, {"friction", 0.3}, {"shape", shape}};
  tool["path"] = {{{"time", 0}, {"position", {-0.02, 0.0501, 0.001}}},
                  {{"time", 0.3}, {"position", {-0.02, 0.047, 0.001}}},
                  {{"time", 0.4}},
                  {{"time", 1}, {"position", {0.02, 0.047, 0.001}}}};
  return read_scene_content("sliding tool", scene.dump());
}

}  // namespace

TEST_CASE("sharp edges that slide over tissue do not hook into it", "[contact]") {
  const auto [name, shape] = GENERATE(table<const char*, const char*>(
      {{"box", R"({"box":{"center":[0,0.02,0],"half_size":[0.025,0.02,0.02]}})"},
       {"cylinder", R"({"cylinder":{"from":[0,0,0],"to":[0,0.04,0],"radius":0.02}})"}}));
  Gpu gpu;
  const Scene scene = slide(nlohmann::json::parse(shape));
  TetMesh mesh = make_box(24, 8, 15, {0.16, 0.05, 0.1});
  for (Eigen::Vector3d& x : mesh.positions) x -= Eigen::Vector3d(0.08, 0, 0.05);
  Simulation run(scene, build_model(scene, {mesh}), &gpu.programs, false);
  Eigen::Vector3d force(0, 0, 0);  // on the tissue, in the last tenth of a second
  for (int step = 0; step < 60; ++step) {
    run.step();
    if (step < 54) continue;
    for (const Eigen::Vector3d& of_vertex : run.contact_forces()) force += of_vertex / 6;
  }
  CAPTURE(name, force.transpose());
  CHECK(force.y() < -1);
  CHECK(force.x() / -force.y() == Approx(0.3).margin(0.06));
}
