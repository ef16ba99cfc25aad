#include "app/bench/fill/rigid_motion.h"

#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

/// A bar away from the origin that nothing holds, each vertex with a velocity of its own, up to 1 m/s: of linear tets,
/// of quadratic ones, or half of each.
Model struck_bar(const std::string& elements) {
  Model model = box_model(8, 2, 2, {0.4, 0.1, 0.1}, soft(1e5));
  for (Vector3d& x : model.file_mesh.positions) x += Vector3d(0.3, -0.2, 0.5);
  model.rest_positions = model.file_mesh.positions;
  if (elements != "linear")
    model = quadratic(model, elements == "both" ? static_cast<std::uint32_t>(model.tets.size() / 2) : 0);
  model.initial_velocity = random_state(model, 0.1, 5).velocity;
  return model;
}

State at_start(const Model& model) {
  State state = initial_state(model);
  state.velocity = model.initial_velocity;
  return state;
}

}  // namespace

TEST_CASE("velocities without the rigid motion have neither momentum nor angular momentum") {
  const std::string elements = GENERATE("linear", "quadratic", "both");
  CAPTURE(elements);
  Model model = struck_bar(elements);
  const reference::Measures before = reference::measure(model, at_start(model));
  remove_rigid_motion(model);
  const reference::Measures after = reference::measure(model, at_start(model));
  CHECK(before.momentum.norm() > 0.01);
  CHECK(before.angular_momentum.norm() > 0.01);
  CHECK(after.momentum.norm() < 1e-13);
  CHECK(after.angular_momentum.norm() < 1e-13);
  CHECK(after.kinetic < before.kinetic);
  CHECK(after.kinetic > 0.9 * before.kinetic);  // six of hundreds of directions are rigid
}

TEST_CASE("of a rigid motion nothing is left, and of what is left all stays") {
  const std::string elements = GENERATE("linear", "quadratic", "both");
  CAPTURE(elements);
  Model model = struck_bar(elements);
  remove_rigid_motion(model);
  const std::vector<Vector3d> once = model.initial_velocity;
  for (std::size_t v = 0; v < once.size(); ++v)
    model.initial_velocity[v] += Vector3d(0.2, -0.7, 0.4) + Vector3d(3, 1, -2).cross(model.rest_positions[v]);
  remove_rigid_motion(model);
  for (std::size_t v = 0; v < once.size(); ++v) CHECK((model.initial_velocity[v] - once[v]).norm() < 1e-12);
}

TEST_CASE("the solver keeps a body at its place from which the rigid motion was taken", "[gpu]") {
  const std::string elements = GENERATE("linear", "quadratic");
  CAPTURE(elements);
  Gpu gpu;
  Model model = struck_bar(elements);
  for (Vector3d& v : model.initial_velocity) v *= 0.1;
  const double kinetic = reference::measure(model, at_start(model)).kinetic, mass = 4;
  remove_rigid_motion(model);
  SolverSettings settings = frames();
  settings.integrator = Integrator::bdf2;
  GpuSolver solver(gpu.programs, model, settings);
  solver.upload(at_start(model));
  for (int step = 0; step < 20; ++step) solver.step();
  solver.request_diagnostics();
  const auto after = solver.take_diagnostics(true);
  REQUIRE(after);
  const double scale = std::sqrt(2 * mass * kinetic);  // the momentum of the body with all of that energy
  CHECK(after->momentum.norm() < 1e-4 * scale);
  CHECK(after->angular_momentum.norm() < 1e-4 * scale);
}
