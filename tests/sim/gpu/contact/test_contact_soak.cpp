// A cube lies on a table for a long time, without sleep: it neither creeps nor gains energy, and its forces stay.
// Covers: contact_term, contact_passes
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kSide = 0.2;  // [m]
constexpr int kLooks = 20;

// On level ground, or at half of the slope at which it slides.
Model lying_cube(double young_modulus, bool slope) {
  Material material;
  material.young_modulus = young_modulus;
  material.damping = 0.05;
  Model model =
      test::make_model(make_box(3, 3, 3, {kSide, kSide, kSide}), material, [](const Vector3d&) { return false; });
  model.gravity = {slope ? 0.25 * 9.81 : 0, -9.81, 0};
  Tool table;
  table.name = "table";
  table.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
  table.friction = 0.5;
  table.path = {{}};
  model.tools = {table};
  return model;
}

struct Lying {
  Vector3d middle{0, 0, 0}, force{0, 0, 0};
  State state;
  double energy = 0, kinetic = 0, rounding = 0;  // rounding of the inertia's force in float32 [N]
};

Lying look_at(GpuSolver& solver, const Model& model) {
  solver.request_diagnostics();
  Lying lying;
  const Diagnostics diagnostics = *solver.take_diagnostics(true);
  lying.force = diagnostics.tool_loads[0].force;
  lying.rounding = diagnostics.force_rounding;
  lying.state = solver.download();
  for (const Vector3d& u : lying.state.displacement)
    lying.middle += u / static_cast<double>(lying.state.displacement.size());
  const reference::Measures measures = reference::measure(model, lying.state);
  lying.energy = measures.elastic;
  lying.kinetic = measures.kinetic;
  return lying;
}

// For `steps` steps after four seconds in which it comes to rest; its middle stays to `creep` of its side.
void lie(double young_modulus, bool slope, int steps, double creep) {
  test::Gpu gpu;
  const Model model = lying_cube(young_modulus, slope);
  SolverSettings settings;
  settings.time_step = 1.0 / 60;
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  for (int i = 0; i < 240; ++i) solver.step();
  const Lying first = look_at(solver, model);
  const Vector3d weight = 1000 * kSide * kSide * kSide * model.gravity;
  // In float32: of the inertia, and of a penalty of 10 (lambda + 2 mu) A / l over a layer of cells, by places as large
  // as the cube, which differs from point to point.
  const double rounding = first.rounding + 10 * 1.35 * young_modulus * 3 * kSide * std::ldexp(kSide, -24);
  double farthest = 0, largest_force = 0, largest_energy = 0, largest_kinetic = 0;
  Vector3d mean(0, 0, 0);
  for (int i = 1; i <= steps; ++i) {
    solver.step();
    if (i % (steps / kLooks) != 0) continue;
    const Lying now = look_at(solver, model);
    farthest = std::max(farthest, test::farthest(now.state, first.state));
    mean += now.force / kLooks;
    largest_force = std::max(largest_force, (now.force + weight).norm());
    largest_energy = std::max(largest_energy, std::abs(now.energy - first.energy));
    largest_kinetic = std::max(largest_kinetic, now.kinetic);
  }
  const Lying last = look_at(solver, model);
  CAPTURE(young_modulus, slope, steps, farthest / kSide, (last.middle - first.middle).transpose() / kSide,
          largest_force / weight.norm(), (mean + weight).norm() / weight.norm(), rounding,
          largest_energy / first.energy, largest_kinetic / first.energy);
  CHECK(farthest < 5e-7 * kSide);  // it moves to and fro by 2e-7, and no farther in 12,000 steps than in 1,000
  CHECK((last.middle - first.middle).norm() < creep * kSide);
  CHECK(largest_force < 1e-5 * weight.norm() + rounding);
  CHECK((mean + weight).norm() < 1e-5 * weight.norm() + rounding);
  CHECK(largest_energy < 1e-4 * first.energy);
  CHECK(largest_kinetic < 1e-6 * first.energy);
}

TEST_CASE("a cube on a table does not creep", "[gpu][contact]") {
  lie(GENERATE(2e4, 1e6), GENERATE(false, true), 1000, 2e-8);
}

TEST_CASE("a cube on a table does not creep in half an hour", "[slow]") {
  // Of 20 kPa on the slope it is 3.5e-8 farther down then, by rounding.
  lie(GENERATE(2e4, 1e6), GENERATE(false, true), 100'000, 1e-7);
}

}  // namespace
}  // namespace fascia
