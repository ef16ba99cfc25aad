// Reactions of supports of quadratic tets: what the GPU sums up against the reference solver's sums, and both against
// the momentum of what free vertices move.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

TEST_CASE("reactions balance the momentum of linear and quadratic bodies, still and shaken", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  const bool shaken = GENERATE(false, true);
  Gpu gpu(loads);
  Model model = linear_and_quadratic_bar(4, 0.2, {2e4, 0.3, 1000, 0, MaterialModel::squared});
  if (shaken) shake_fixed(model);
  SolverSettings settings = frames();
  settings.integrator = integrator;
  settings.iterations = 100;
  settings.rest_speed = 0;
  const auto tip = static_cast<std::uint32_t>(model.rest_positions.size() - 1);
  GpuSolver solver(gpu.programs, model, settings);
  solver.set_grab({{tip, {0.02, 0.05, 0}, 20}});
  const Vector3d weight = weight_of(model);
  State before = initial_state(model), earlier = before;
  double largest = 0;
  for (int step = 0; step < 8; ++step) {
    const IntegratorStage stage = stages_of(integrator, settings.time_step, step == 0 ? 0 : settings.time_step).back();
    solver.step();
    solver.request_diagnostics();
    const Diagnostics d = *solver.take_diagnostics(true);
    const State state = solver.download();
    Vector3d start = free_momentum(model, before.velocity), start_earlier = free_momentum(model, earlier.velocity);
    if (integrator == Integrator::sdirk2) {  // the second stage begins where the first ended
      start_earlier = start;
      start = free_momentum(model, solver.buffers().download_vectors(solver.buffers().earlier_velocity));
    }
    start = stage.extrapolated(start, start_earlier);
    const Vector3d inertia = (free_momentum(model, state.velocity) - start) / stage.length;
    const Vector3d missing = d.reaction + weight + d.grab_force - inertia;
    const double scale = weight.norm() + inertia.norm();
    CAPTURE(gl::name_of(loads), name_of(integrator), shaken, step, d.reaction.transpose(), inertia.transpose(),
            missing.norm() / scale);
    CHECK(missing.norm() < 1e-5 * scale);
    CHECK((d.inertia - inertia).norm() < 1e-5 * scale);
    CHECK((d.reaction - reference::measure(model, state).fixed_reaction).norm() < 1e-5 * scale);
    State bare = state;
    bare.acceleration.clear();
    largest = std::max(largest, (d.reaction - reference::measure(model, bare).fixed_reaction).norm());
    earlier = before;
    before = state;
  }
  CAPTURE(gl::name_of(loads), name_of(integrator), shaken, largest);
  CHECK(largest > 2e-4 * weight.norm());

  // A state that is set is not the end of a step.
  State set = solver.download();
  solver.upload(set);
  set.acceleration.clear();
  CHECK(solver.download().acceleration.empty());
  solver.request_diagnostics();
  const Vector3d reaction = solver.take_diagnostics(true)->reaction;
  CHECK((reaction - reference::measure(model, set).fixed_reaction).norm() < 1e-5 * weight.norm());
}
