// Jaws that are larger than what they lift hold it by friction, in steps of ten iterations.
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

// A cube of 4 cm on the ground, which box jaws of 6 cm squeeze by 1.5 mm a side, lift by 5 cm in a second, and hold.
// Friction could bear twice its weight.
Scene lifted_cube(double open_deg, Integrator integrator) {
  constexpr double kOpen = 26.991466561591607, kClosed = 20.962436288261823;  // [deg]
  const auto grip = [&](double angle) { return 1 - angle / open_deg; };
  nlohmann::json scene{{"fascia_scene", 1}};
  scene["bodies"][0] = {{"name", "cube"}, {"mesh", "cube"}};
  scene["bodies"][0]["materials"]["default"] = {
      {"young_modulus", 2e4}, {"poisson_ratio", 0.3}, {"density", 1000}, {"damping", 0.02}};
  scene["ground"] = {{"height", 0}, {"friction", 0.5}};
  nlohmann::json& jaws = scene["instruments"][0];
  jaws = {{"name", "jaws"}, {"friction", 0.5}};
  jaws["jaws"] = {{"axis", {0, 0, 1}}, {"open_deg", open_deg}};
  jaws["jaws"]["shape"]["box"] = {{"center", {0.1, 0.004, 0}}, {"half_size", {0.03, 0.004, 0.03}}, {"round", 0.001}};
  jaws["path"] = {{{"time", 0}, {"position", {-0.1, 0.02, 0}}, {"grip", grip(kOpen)}, {"rotate_deg", {90, 0, 0}}},
                  {{"time", 0.5}, {"grip", grip(kClosed)}},
                  {{"time", 0.7}},
                  {{"time", 1.7}, {"position", {-0.1, 0.07, 0}}},
                  {{"time", 2.4}}};
  Scene read = read_scene_content("lifted cube", scene.dump());
  read.solver.integrator = integrator;
  return read;
}

TetMesh cube_to_lift() {
  TetMesh mesh = make_box(6, 6, 6, {0.04, 0.04, 0.04});
  for (Eigen::Vector3d& x : mesh.positions) x -= Eigen::Vector3d(0.02, 0, 0.02);
  return mesh;
}

}  // namespace

TEST_CASE("box jaws hold a cube that is smaller than they are") {
  const double open_deg = GENERATE(90, 100);
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2);
  Gpu gpu;
  const Scene scene = lifted_cube(open_deg, integrator);
  Simulation run(scene, build_model(scene, {cube_to_lift()}), &gpu.programs, false);
  for (int step = 0; step < 144; ++step) run.step();
  const State state = run.state();
  double lift = 0, mass = 0, force = 0;
  const std::vector<double> masses = lumped_masses(run.model);
  const std::vector<Eigen::Vector3d> forces = run.contact_forces();
  for (std::size_t v = 0; v < masses.size(); ++v) {
    lift += masses[v] * state.displacement[v].y();
    mass += masses[v];
    force += forces[v].y();
  }
  CAPTURE(open_deg, name_of(integrator), lift / mass, force / (9.81 * mass));
  CHECK(lift / mass == Approx(0.049).margin(0.001));
  CHECK(force == Approx(9.81 * mass).epsilon(1e-2));
}
