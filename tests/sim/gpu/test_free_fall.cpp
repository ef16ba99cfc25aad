// Unconstrained bodies fall as gravity requires, for any stiffness and size.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// `count` boxes of cells beside each other, the first one fixed at its bottom if `held`.
Model boxes(int count, const Eigen::Vector3i& cells, bool held) {
  TetMesh all;
  for (int b = 0; b < count; ++b) {
    const TetMesh box = make_box(cells.x(), cells.y(), cells.z(), 0.02 * cells.cast<double>());
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const Vector3d& x : box.positions) all.positions.push_back(x + Vector3d(0.1 * b, 0, 0));
    for (Tet tet : box.tets) {
      for (std::uint32_t& v : tet) v += first;
      all.tets.push_back(tet);
    }
  }
  return make_model(all, {1e6, 0.3, 1000}, [=](const Vector3d& x) { return held && x.x() < 0.05 && x.y() < 1e-9; });
}

Model one_tet() {
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  mesh.tets = {{0, 1, 2, 3}};
  return make_model(mesh, {1e6, 0.3, 1000}, [](const Vector3d&) { return false; });
}

}  // namespace

TEST_CASE("unconstrained bodies fall freely, for any stiffness and size", "[gpu]") {
  const bool held = GENERATE(false, true);
  const auto method = GENERATE(Method::two_level, Method::vertex_descent);
  Gpu gpu;
  std::vector<Model> models{boxes(2, {1, 1, 1}, held), boxes(2, {2, 2, 1}, held), boxes(60, {2, 1, 1}, held)};
  if (!held) models.push_back(one_tet());
  SolverSettings settings;
  settings.method = method;
  settings.acceleration = method == Method::two_level ? Acceleration::subspace : Acceleration::none;
  constexpr int kSteps = 20;
  for (const Model& model : models) {
    GpuSolver solver(gpu.programs, model, settings);
    for (int i = 0; i < kSteps; ++i) solver.step();
    const State state = solver.download();
    // By implicit Euler
    const Vector3d fall = kSteps * (kSteps + 1) / 2 * settings.time_step * settings.time_step * model.gravity;
    double error = 0;
    for (std::size_t v = 0; v < state.displacement.size(); ++v)
      if (!held || model.rest_positions[v].x() > 0.05) error = std::max(error, (state.displacement[v] - fall).norm());
    CAPTURE(name_of(method), held, model.tets.size(), error, fall.y());
    CHECK(error < 1e-5 * fall.norm());
  }
}

TEST_CASE("vertices that no tet has stay where they are when their body is thrown", "[gpu]") {
  Gpu gpu;
  Model model = one_tet();
  model.rest_positions.push_back({0.3, 0, 0});
  model.file_mesh.positions = model.rest_positions;
  model.bodies[0].vertex_count = 5;
  model.initial_velocity.assign(5, Vector3d(1, 2, -0.5));
  GpuSolver solver(gpu.programs, model, {});
  for (int i = 0; i < 10; ++i) solver.step();
  const State state = solver.download();
  CAPTURE(state.displacement[0].transpose(), state.displacement[4].transpose());
  CHECK(state.displacement[4] == Vector3d(0, 0, 0));
  CHECK(state.displacement[0].x() == Approx(1.0 / 6));
}
