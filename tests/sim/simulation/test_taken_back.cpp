// What becomes of bodies that a step would have led through each other (PairSearch::taken_back()).
// Covers: simulation
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/newton.h"
#include "sim/simulation/simulation.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// A soft and a stiff cube of 4 cm that meet off center, each at this speed [m/s], the latter corner first.
Scene off_center(Integrator integrator, double speed, int substeps) {
  nlohmann::json scene{{"fascia_scene", 1}, {"gravity", {0, 0, 0}}, {"contact", {{"friction", 0.3}}}};
  for (const bool stiff : {false, true}) {
    nlohmann::json body{{"name", stiff ? "stiff" : "soft"}, {"mesh", "box"}};
    body["materials"]["default"] = {
        {"young_modulus", stiff ? 1e6 : 1e3}, {"poisson_ratio", 0.4}, {"density", 1000}, {"damping", 0.02}};
    body["initial_velocity"] = {stiff ? -speed : speed, 0, 0};
    if (stiff)
      body["transform"] = {{"translate", {0.022, -0.00955, -0.00017}}, {"rotate_deg", {26.73, 25.91, 10.46}}};
    else
      body["transform"] = {{"translate", {-0.062, 0, 0}}};
    scene["bodies"].push_back(body);
  }
  Scene read = read_scene_content("off center", scene.dump());
  read.solver.integrator = integrator;
  read.solver.substeps = substeps;
  return read;
}

struct Sums {
  Vector3d momentum{0, 0, 0}, angular{0, 0, 0};
  double energy = 0;
};

Sums sums_of(const Model& model, const State& state) {
  const std::vector<double> masses = consistent_masses(model);
  Sums sums;
  for (std::size_t v = 0; v < masses.size(); ++v) {
    const Vector3d momentum = masses[v] * state.velocity[v];
    sums.momentum += momentum;
    sums.angular += (model.rest_positions[v] + state.displacement[v]).cross(momentum);
  }
  const reference::Measures measures = reference::measure(model, state);
  sums.energy = measures.kinetic + measures.elastic;
  return sums;
}

}  // namespace

TEST_CASE("bodies that meet off center in short steps keep their angular momentum") {
  const Integrator integrator = GENERATE(Integrator::bdf2, Integrator::sdirk2);
  const bool by_reference = GENERATE(true, false);
  Gpu gpu;
  const Scene scene = off_center(integrator, 1, 32);
  const TetMesh cube = make_box(2, 2, 2, {0.04, 0.04, 0.04});
  Simulation run(scene, build_model(scene, {cube, cube}), by_reference ? nullptr : &gpu.programs, by_reference);
  const Sums before = sums_of(run.model, run.state());
  for (int step = 0; step < 4; ++step) run.step();
  const Sums after = sums_of(run.model, run.state());
  CAPTURE(name_of(integrator), by_reference, before.angular.transpose(), after.angular.transpose(), before.energy,
          after.energy);
  // 64 g at 1 m/s. Displacements in single precision are 4e-9 m off, velocities of stages of 1.5e-4 s by 3e-5 m/s.
  CHECK((after.momentum - before.momentum).norm() < (by_reference ? 1e-12 : 1e-3) * 0.064);
  CHECK((after.angular - before.angular).norm() < 0.05 * before.angular.norm());
  CHECK(after.energy < before.energy);
  CHECK(after.energy > 0.25 * before.energy);
}

// At 32 m/s, 27 cm in a substep.
TEST_CASE("bodies that a step would lead through each other are taken back and keep their momentum") {
  const bool by_reference = GENERATE(true, false);
  Gpu gpu;
  const Scene scene = off_center(Integrator::bdf2, 16, 2);
  const TetMesh cube = make_box(2, 2, 2, {0.04, 0.04, 0.04});
  Simulation run(scene, build_model(scene, {cube, cube}), by_reference ? nullptr : &gpu.programs, by_reference);
  const Sums before = sums_of(run.model, run.state());
  for (int step = 0; step < 4; ++step) run.step();
  const Sums after = sums_of(run.model, run.state());
  CAPTURE(by_reference, run.taken_back(), (after.momentum - before.momentum).transpose(), before.energy, after.energy);
  CHECK(run.taken_back() > 0);
  CHECK((after.momentum - before.momentum).norm() < (by_reference ? 1e-12 : 1e-4) * 0.64);
  CHECK(after.energy < before.energy);
}
