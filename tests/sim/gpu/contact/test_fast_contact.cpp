// Contact on the GPU where much happens in a step: impacts at several m/s, bodies that scripts move, heavy loads.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "sim/contact/tissue/penetration.h"
#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "sim/surface/surface_fill.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/surfaces.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

SolverSettings step_settings() {
  SolverSettings settings;
  settings.method = Method::two_level;
  settings.acceleration = Acceleration::subspace;
  settings.iterations = 10;
  settings.time_step = 1.0 / 60;
  return settings;
}

Model closing_cubes(const Vector3d& closing) {
  Model model = test::beside(
      test::box_model(3, 3, 3, {0.2, 0.2, 0.2}, test::soft(1e5)),
      test::moved(test::box_model(4, 4, 4, {0.2, 0.2, 0.2}, test::soft(1e5)), {0.21, 0.03, 0.02}, -closing), "second");
  model.contact.friction = 0.3;
  return model;
}

double lowest_of(const Model& model, const State& state) {
  double lowest = 1e9;
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    lowest = std::min(lowest, model.rest_positions[v].y() + state.displacement[v].y());
  return lowest;
}

// Faster than a table's thickness in a step: the side that points enter by holds them, not the nearest one.
TEST_CASE("a cube that falls on a table at any speed stays above it", "[gpu][contact]") {
  test::Gpu gpu;
  const auto [young, speed] = GENERATE(std::pair(1e4, 6.0), std::pair(1e5, 6.0), std::pair(1e5, 10.0));
  Model model = test::moved(test::box_model(5, 5, 5, {0.1, 0.1, 0.1}, test::soft(young, 0.3, 0.02)), {0, 0.05, 0},
                            {0.2, -speed, 0});
  model.materials[0].model = MaterialModel::squared;
  model.gravity = {0, -9.81, 0};
  Tool table;
  table.name = "table";
  table.shape = BoxShape{{0, -0.05, 0}, {0.5, 0.05, 0.5}};
  table.friction = 0.5;
  table.path.emplace_back();
  model.tools = {table};
  GpuSolver solver(gpu.programs, model, step_settings());
  double lowest = 0;
  for (int i = 0; i < 60; ++i) {
    solver.step();
    lowest = std::min(lowest, lowest_of(model, solver.download()));
  }
  const State end = solver.download();
  CAPTURE(young, speed, lowest, lowest_of(model, end));
  CHECK(lowest > -0.015);
  CHECK(lowest_of(model, end) > -1e-4);
  CHECK(reference::measure(model, end).inverted == 0);
}

TEST_CASE("bodies that close fast do not go through each other", "[gpu][contact]") {
  test::Gpu gpu;
  const auto [young, speed] = GENERATE(std::pair(1e4, 3.0), std::pair(1e5, 6.0), std::pair(1e6, 10.0));
  Model model = closing_cubes({speed, 0, 0});
  for (Material& material : model.materials) {
    material.young_modulus = young;
    material.model = MaterialModel::squared;
    material.damping = 0.02;
  }
  GpuSolver solver(gpu.programs, model, step_settings());
  for (int i = 0; i < 30; ++i) {
    solver.step();
    CAPTURE(young, speed, i);
    CHECK(penetrating_triangles(model, solver.download().displacement) == 0);
  }
}

// Of one body with the other; folds of a body, which may pass through each other here, are left out.
std::size_t cuts_between_bodies(const Model& model, std::vector<Vector3d> displacement) {
  const std::size_t all = penetrating_triangles(model, displacement);
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < displacement.size(); ++v) displacement[v].x() += 100;
  return all - penetrating_triangles(model, displacement);
}

// Iterations alone stretched the cube as they turned it: elastic energy rose to 0.03 J here, and to 0.5 J on another
// mesh.
TEST_CASE("a stiff cube that falls on the edge of a stiff beam gains no energy", "[gpu][contact]") {
  const auto [order, iterations] = GENERATE(std::pair(ElementOrder::linear, 5), std::pair(ElementOrder::linear, 10),
                                            std::pair(ElementOrder::quadratic, 10));
  test::Gpu gpu;
  Material beam = test::soft(3e6, 0.4, 0.01), hit = beam;
  beam.density = 900;
  hit.density = 1200;
  beam.model = hit.model = MaterialModel::squared;
  Model cube = test::box_model(3, 3, 3, {0.05, 0.05, 0.05}, hit);
  const Eigen::AngleAxisd turn(0.25 * std::numbers::pi, Vector3d::UnitY());
  for (Vector3d& x : cube.rest_positions) x = turn * x;
  Model model =
      test::beside(test::box_model(8, 2, 2, {0.2, 0.04, 0.05}, beam), test::moved(cube, {0.08, 0.09, 0.03}), "cube");
  if (order == ElementOrder::quadratic) model = test::quadratic(model);
  model.gravity = {0, -9.81, 0};
  model.contact.friction = 0.35;
  Tool ground;
  ground.name = "ground";
  ground.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
  ground.friction = 0.5;
  ground.path.emplace_back();
  model.tools = {ground};
  SolverSettings settings = step_settings();
  settings.iterations = iterations;
  GpuSolver solver(gpu.programs, model, settings);
  double most = 0, elastic = 0;
  const auto energy = [&] {
    solver.request_diagnostics();
    const Diagnostics d = *solver.take_diagnostics(true);
    elastic = std::max(elastic, d.elastic);
    return d.elastic + d.kinetic + d.gravitational;
  };
  const double start = energy();
  for (int i = 0; i < 18; ++i) {
    solver.step();
    most = std::max(most, energy() - start);
  }
  CAPTURE(name_of(order), iterations, most, elastic);
  CHECK(most < 1e-5);
  CHECK(elastic < 0.01);  // it falls with 0.02 J
}

// In one step the cubes would go through most of each other, ten times as fast as waves go in them.
TEST_CASE("bodies that no search of a step keeps apart are taken back", "[gpu][contact]") {
  test::Gpu gpu;
  long taken_back = 0;
  for (const double speed : {9.8, 10.0, 10.2}) {
    const Model cube = test::box_model(5, 5, 5, {0.1, 0.1, 0.1}, test::soft(1e3, 0.3, 0.01));
    Model model = test::beside(cube, test::moved(cube, {0.11, 0.03, 0.02}, {-speed, 0, 0}), "second");
    model.contact.friction = 0.3;
    for (Material& material : model.materials) material.model = MaterialModel::squared;
    GpuSolver solver(gpu.programs, model, step_settings());
    for (int i = 0; i < 12; ++i) {
      solver.step();
      CAPTURE(speed, i, solver.taken_back());
      CHECK(cuts_between_bodies(model, solver.download().displacement) == 0);
    }
    taken_back += solver.taken_back();
  }
  CHECK(taken_back > 0);
}

// The velocity of the held body says nothing of the step to come.
TEST_CASE("a body whose vertices are prescribed pushes another one", "[gpu][contact]") {
  test::Gpu gpu;
  Model model = closing_cubes({0, 0, 0});
  const double duration = GENERATE(0.3, 0.05, 0.0);
  Motion motion;
  for (std::uint32_t v = 0; v < model.bodies[0].vertex_count; ++v) motion.vertices.push_back(v);
  motion.translate = {0.15, 0, 0};
  motion.duration = duration;
  model.motions = {motion};
  for (Material& material : model.materials) material.model = MaterialModel::squared;
  GpuSolver solver(gpu.programs, model, step_settings());
  for (int i = 0; i < 30; ++i) {
    solver.step();
    CAPTURE(duration, i);
    CHECK(penetrating_triangles(model, solver.download().displacement) == 0);
  }
  const State end = solver.download();
  double least = 1e9;
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.displacement.size(); ++v)
    least = std::min(least, model.rest_positions[v].x() + end.displacement[v].x());
  CHECK(least > 0.35);
}

// Each presses the other to half of its thickness and less.
TEST_CASE("rings caught in each other stay so under a load of some times their weight", "[gpu][contact]") {
  test::Gpu gpu;
  const auto [young, density] = GENERATE(std::pair(1e4, 3e3), std::pair(1e6, 3e5));
  const auto ring = [](const Eigen::Matrix3d& turn, double held_above) {
    SurfaceMesh surface = test::make_torus(40, 12, 0.05, 0.012);
    for (Vector3d& x : surface.positions) x = turn * x;
    const MeshFile file = fill_surface(std::move(surface), "ring", 14).file;
    Material material = test::soft(0, 0.4, 0.02);
    material.model = MaterialModel::squared;
    return test::make_model(file.mesh, material, [&](const Vector3d& x) { return x.y() > held_above; });
  };
  const Eigen::Matrix3d upright = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d across = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitY()) * upright;
  Model model = test::beside(ring(upright, 0.045), test::moved(ring(across, 1), {0, -0.05, 0}), "second");
  for (Material& material : model.materials) material.young_modulus = young;
  model.materials[1].density = density;
  model.gravity = {0, -9.81, 0};
  model.contact.friction = 0.3;
  GpuSolver solver(gpu.programs, model, step_settings());
  for (int i = 0; i < 90; ++i) {
    solver.step();
    CAPTURE(young, density, i);
    CHECK(penetrating_triangles(model, solver.download().displacement) == 0);
  }
  const State end = solver.download();
  Vector3d middle(0, 0, 0);
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.displacement.size(); ++v)
    middle += (model.rest_positions[v] + end.displacement[v]) / model.bodies[1].vertex_count;
  CAPTURE(middle.transpose());
  CHECK(middle.y() > -0.3);
  CHECK(middle.y() < -0.1);
}

}  // namespace
}  // namespace fascia
