// Most steps omit regions at rest; the result equals that of whole steps within a small part of the scene's size.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// A flat sheet of 4,800 tets, clamped along its long sides, so that a motion at one end hardly reaches the other.
Model sheet(double damping) {
  Model model = make_model(make_box(40, 10, 2, {0.8, 0.2, 0.04}), tissue(damping),
                           [](const Vector3d& x) { return x.y() < 1e-9 || x.y() > 0.2 - 1e-9; });
  model.gravity = {0, 0, -9.81};
  return model;
}

// Two bars side by side, each clamped at its end: 4,608 tets.
Model two_stiff_bars() {
  return two_bars(24, 0.6,
                  {2e6, 0.4, 1000, 0.1, MaterialModel::st_venant_kirchhoff});  // at rest under its weight after 2 s
}

// The sheet with the same vertices, of quadratic tets.
Model quadratic_sheet(double damping) {
  Model model = make_model(make_box(20, 5, 1, {0.8, 0.2, 0.04}), tissue(damping),
                           [](const Vector3d& x) { return x.y() < 1e-9 || x.y() > 0.2 - 1e-9; });
  model.gravity = {0, 0, -9.81};
  return quadratic(std::move(model));
}

// The bars, of linear tets, of quadratic ones, or one of each.
enum class Bars { linear, quadratic, mixed };
Model stiff_bars(Bars bars) {
  const Material material{2e6, 0.4, 1000, 0.1, MaterialModel::st_venant_kirchhoff};
  return bars == Bars::linear      ? two_stiff_bars()
         : bars == Bars::quadratic ? quadratic(two_bars(8, 0.6, material))
                                   : linear_and_quadratic_bar(12, 0.6, material);
}

// The sheet's equilibrium under its weight, which has no damping in it: with this much, the sheet is there within a
// second and a half.
constexpr double kSettling = 0.05;  // [s]
State at_rest(Gpu& gpu, const Model& damped, const SolverSettings& settings) {
  GpuSolver solver(gpu.programs, damped, settings);
  solver.solve_everything();
  for (int i = 0; i < 100; ++i) solver.step();
  State rest = solver.download();
  for (Vector3d& v : rest.velocity) v.setZero();
  return rest;
}

std::uint32_t vertex_at(const Model& model, const Vector3d& place) {
  std::uint32_t nearest = 0;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if ((model.rest_positions[v] - place).norm() < (model.rest_positions[nearest] - place).norm()) nearest = v;
  return nearest;
}

}  // namespace

TEST_CASE("a poke into a resting sheet moves it as whole steps do", "[gpu]") {
  struct Case {
    Acceleration acceleration;
    double damping, rest_speed, largest_share;
    bool quadratic = false;
  };
  const Case with_case =
      GENERATE(Case{Acceleration::subspace, 0, 1e-5, 0.9}, Case{Acceleration::subspace, 0.02, 1e-5, 0.75},
               Case{Acceleration::nonlinear_cg, 0.02, 1e-5, 0.75}, Case{Acceleration::subspace, 0.02, 1e-3, 0.6},
               Case{Acceleration::subspace, 0.02, 1e-3, 0.75, true});
  const double damping = with_case.damping;
  SolverSettings settings = with(SolverChoice{Method::two_level, with_case.acceleration});
  settings.rest_speed = with_case.rest_speed;
  CAPTURE(name_of(settings.acceleration), damping, settings.rest_speed, with_case.quadratic);
  Gpu gpu;
  const Model model = with_case.quadratic ? quadratic_sheet(damping) : sheet(damping);
  GpuSolver skipping(gpu.programs, model, settings);
  GpuSolver whole(gpu.programs, model, settings);
  whole.solve_everything();
  const double size = whole.buffers().size;
  // Both start from the same state of rest.
  const State rest = at_rest(gpu, with_case.quadratic ? quadratic_sheet(kSettling) : sheet(kSettling), settings);
  whole.upload(rest);
  skipping.upload(rest);
  const std::uint32_t vertex = vertex_at(model, {0.05, 0.1, 0.04});
  const Vector3d start = rest.displacement[vertex];
  double largest = 0;
  for (int step = 0; step < 160; ++step) {
    std::vector<GrabSpring> springs;  // pulled up, kept there, released
    if (step < 100) springs.push_back({vertex, start + Vector3d(0, 0, 0.02 * std::min(1.0, step / 40.0)), 100});
    whole.set_grab(springs);
    skipping.set_grab(springs);
    whole.step();
    skipping.step();
    if (step % 8 == 7) {  // as in the simulation
      skipping.request_check();
      REQUIRE(skipping.take_check(true));
    }
    largest = std::max(largest, farthest(whole.download(), skipping.download()));
  }
  CAPTURE(largest / size, skipping.share_solved());
  CHECK(largest < 2 * settings.rest_speed * size);  // the distance that counts as rest over 2 s; 160 steps are 2.7 s
  CHECK(skipping.share_solved() < with_case.largest_share);
  CHECK(whole.share_solved() == 1);
}

TEST_CASE("a body at rest beside a moving one costs almost nothing and keeps its bits", "[gpu]") {
  const Bars bars = GENERATE(Bars::linear, Bars::quadratic, Bars::mixed);
  CAPTURE(static_cast<int>(bars));
  Gpu gpu;
  const Model model = stiff_bars(bars);
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::subspace}));
  for (int i = 0; i < 300; ++i) solver.step();
  const std::uint32_t tip = vertex_at(model, {0.6, 0.05, 0.05});
  const long before = solver.steps_solved();
  const double share_before = solver.share_solved();
  int partial = 0, unchanged = 0;
  for (int step = 0; step < 64; ++step) {
    const double swing = 0.05 * std::sin(0.2 * step);
    solver.set_grab({{tip, {0, swing, 0}, 500}});
    const State last = solver.download();
    solver.step();
    const State now = solver.download();
    if (solver.last_was_whole()) continue;
    ++partial;
    bool same = true;
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
      if (model.rest_positions[v].y() > 0.2) same &= now.displacement[v] == last.displacement[v];
    unchanged += same;
    CHECK((now.displacement[tip] - last.displacement[tip]).norm() > 0);
  }
  const double share = (solver.share_solved() * static_cast<double>(solver.steps_solved()) -
                        share_before * static_cast<double>(before)) /
                       static_cast<double>(solver.steps_solved() - before);
  CAPTURE(share, partial);
  CHECK(partial == 6 * 8);
  CHECK(unchanged == partial);
  // Two of eight steps are whole, six have one of the two bars: in the mixed scene the linear one, an eighth of the
  // other
  CHECK(share < (bars == Bars::mixed ? 0.34 : 0.63));
}

TEST_CASE("steps with resting regions repeat bit for bit, also from a checked state", "[gpu]") {
  Gpu gpu;
  const Model model = two_stiff_bars();
  const std::uint32_t tip = vertex_at(model, {0.6, 0.05, 0.05});
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::subspace}));
  for (int i = 0; i < 304; ++i) {
    solver.step();
    if (i % 8 != 7) continue;
    solver.request_check();
    solver.take_check(true);
  }
  const auto pull = [&](GpuSolver& s, int step) { s.set_grab({{tip, {0, 0.002 * step, 0}, 500}}); };
  for (int i = 0; i < 24; ++i) {
    pull(solver, i);
    solver.step();
    if (i % 8 != 7) continue;
    solver.request_check();
    solver.take_check(true);
  }
  CHECK_FALSE(solver.last_was_whole());
  const State checked = solver.download();
  std::vector<State> states;
  GpuSolver again(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::subspace}));
  again.upload(checked);
  for (int i = 24; i < 40; ++i) {
    pull(solver, i);
    pull(again, i);
    solver.step();
    again.step();
    if (i % 8 == 7) {
      solver.request_check();
      solver.take_check(true);
      again.request_check();
      again.take_check(true);
    }
    CAPTURE(i);
    const State a = solver.download(), b = again.download();
    CHECK(a.displacement == b.displacement);
    CHECK(a.velocity == b.velocity);
  }
}

TEST_CASE("readbacks between steps with resting regions do not change their bits", "[gpu]") {
  Gpu gpu;
  Model model = sheet(0.02);
  // Resting tets then have much energy, and a jerking grab causes steps that raise the objective
  model.gravity *= 4;
  SolverSettings settings = with(SolverChoice{Method::two_level, Acceleration::subspace});
  settings.rest_speed = 1e-3;
  settings.iterations = 10;
  GpuSolver unseen(gpu.programs, model, settings);
  GpuSolver seen(gpu.programs, model, settings);
  seen.set_color(ColorBy::von_mises);  // summed in the same slots as the forces of steps
  for (int i = 0; i < 400; ++i) unseen.step();
  State rest = unseen.download();
  for (Vector3d& v : rest.velocity) v.setZero();
  unseen.upload(rest);
  seen.upload(rest);
  const std::uint32_t vertex = vertex_at(model, {0.05, 0.1, 0.04});
  int partial = 0;
  for (int step = 0; step < 64; ++step) {
    const std::vector<GrabSpring> springs{
        {vertex, rest.displacement[vertex] + Vector3d(0, 0, step % 6 < 3 ? 0.06 : -0.06), 200}};
    unseen.set_grab(springs);
    seen.set_grab(springs);
    unseen.step();
    seen.step();
    partial += !unseen.last_was_whole();
    seen.publish();
    seen.request_diagnostics();
    REQUIRE(seen.take_diagnostics(true));
    const State a = unseen.download(), b = seen.download();
    CAPTURE(step, farthest(a, b));
    REQUIRE(a.displacement == b.displacement);
    REQUIRE(a.velocity == b.velocity);
  }
  CHECK(partial > 20);
}

TEST_CASE("kernels of a partial step that are run for a cache change no later step", "[gpu]") {
  Gpu gpu;
  const Model model = sheet(0.02);
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::subspace}));
  GpuSolver other(gpu.programs, model, solver.settings());
  for (int step = 0; step < 6; ++step) {
    solver.step();
    other.step();
    const State before = solver.download();
    solver.run_partial_kernels();
    const State after = solver.download();
    CAPTURE(step, before.time, after.time);
    CHECK(after.time == before.time);
    CHECK(after.displacement == before.displacement);
    CHECK(after.velocity == before.velocity);
    CHECK(after.displacement == other.download().displacement);
  }
}

TEST_CASE("regions rest beside tools that are far away as without them", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const Model model = two_stiff_bars();
  const SolverSettings settings = with(SolverChoice{Method::two_level, Acceleration::subspace});
  // Until the bars are nearly at rest, how kernels read does not matter, and software reads storage ten times slower.
  State settled = initial_state(model);
  if (loads == gl::LoadPath::storage) {
    Gpu quick(gl::LoadPath::texel);
    GpuSolver solver(quick.programs, model, settings);
    while (solver.time() < 4.5) solver.step();
    settled = solver.download();
  }
  Gpu gpu(loads);
  Model with_ball = model;
  Tool ball;
  ball.name = "ball";
  ball.shape = SphereShape{{0, 0, 0}, 0.02};
  ball.path = {{0, {0.3, 0.8, 0.1}, {0, 0, 0}},
               {5.9, {0.3, 0.8, 0.1}, {0, 0, 0}},
               {6, {0.6, 0.0, 0.1}, {0, 0, 0}},
               {6.1, {0.6, 0.0, 0.1}, {0, 0, 0}}};
  with_ball.tools = {ball};
  GpuSolver alone(gpu.programs, model, settings), beside(gpu.programs, with_ball, settings);
  alone.upload(settled);
  beside.upload(settled);
  const std::uint32_t tip = vertex_at(model, {0.6, 0.05, 0.05});
  int partial = 0, touching = 0;
  while (beside.time() < 6.2) {
    const std::vector<GrabSpring> springs{{tip, {0, 0.05 * std::sin(12 * beside.time()), 0}, 500}};
    if (beside.time() > 5) alone.set_grab(springs);
    if (beside.time() > 5) beside.set_grab(springs);
    alone.step();
    beside.step();
    partial += !beside.last_was_whole();
    touching += beside.last_had_contact();
    if (touching > 0) continue;
    REQUIRE(beside.last_was_whole() == alone.last_was_whole());
  }
  CAPTURE(partial, touching);
  CHECK(partial > 20);
  CHECK(touching > 5);
}

TEST_CASE("regions rest while a tool presses others, which move as in whole steps", "[gpu]") {
  struct Case {
    gl::LoadPath loads;
    bool quadratic;
    double speed;  // [m/s] of the ball after it touches
    double until;  // [s]
  };
  const Case with_case =
      GENERATE(Case{gl::LoadPath::texel, false, 0.05, 8.6}, Case{gl::LoadPath::storage, false, 0.05, 7.6},
               Case{gl::LoadPath::texel, true, 0.05, 7.8}, Case{gl::LoadPath::texel, false, 4, 8.6});
  Model model = with_case.quadratic ? quadratic_sheet(0.02) : sheet(0.02);
  SolverSettings settings = with(SolverChoice{Method::two_level, Acceleration::subspace});
  State rest = initial_state(model);
  {
    Gpu fast;  // on software renderers
    GpuSolver free(fast.programs, model, settings);
    free.solve_everything();
    while (free.time() < 7) free.step();
    rest = free.download();
    for (Vector3d& v : rest.velocity) v.setZero();
  }
  Gpu gpu(with_case.loads);
  constexpr double kRadius = 0.02, kDepth = 0.005;
  const double moved = 0.1, time = moved / with_case.speed;  // along the sheet
  const double top = 0.04 + rest.displacement[vertex_at(model, {0.1, 0.1, 0.04})].z();
  Tool ball;
  ball.name = "ball";
  ball.shape = SphereShape{{0, 0, 0}, kRadius};
  ball.friction = 0.3;
  const Vector3d above(0.1, 0.1, top + kRadius + 0.05), pressing(0.1, 0.1, top + kRadius - kDepth);
  ball.path = {{0, above, {0, 0, 0}},
               {7.2, above, {0, 0, 0}},
               {7.6, pressing, {0, 0, 0}},
               {8, pressing, {0, 0, 0}},
               {8 + time, pressing + Vector3d(moved, 0, 0), {0, 0, 0}}};
  model.tools = {ball};
  GpuSolver skipping(gpu.programs, model, settings), whole(gpu.programs, model, settings);
  whole.solve_everything();
  for (GpuSolver* solver : {&skipping, &whole}) solver->upload(rest);
  const auto force_of = [](GpuSolver& solver) {
    solver.request_diagnostics();
    return solver.take_diagnostics(true)->tool_loads.front().force;
  };
  double farthest_apart = 0, largest_force = 0, farthest_force = 0;
  int partial = 0, touching = 0, kept = 0;
  const std::uint32_t far = vertex_at(model, {0.75, 0.1, 0.04});
  while (whole.time() < with_case.until) {
    const Vector3d before = skipping.download().displacement[far];
    for (GpuSolver* solver : {&skipping, &whole}) solver->step();
    const State now = skipping.download();
    farthest_apart = std::max(farthest_apart, farthest(whole.download(), now));
    const Vector3d exact = force_of(whole), force = force_of(skipping);
    largest_force = std::max(largest_force, exact.norm());
    farthest_force = std::max(farthest_force, (force - exact).norm());
    touching += skipping.last_had_contact();
    const bool in_part = skipping.last_had_contact() && !skipping.last_was_whole();
    partial += in_part;
    kept += in_part && now.displacement[far] == before;
  }
  CAPTURE(with_case.quadratic, with_case.speed, partial, touching, farthest_apart, largest_force, farthest_force);
  CHECK(touching > 20);
  CHECK(partial > 10);
  CHECK(kept == partial);
  CHECK(largest_force > 0.1);
  CHECK(farthest_apart < 0.03 * kDepth);  // where the ball starts to slide, at once
  CHECK(farthest_force < 0.01 * largest_force);
}

TEST_CASE("steps in which regions rest while a tool presses others repeat from every checked state", "[gpu]") {
  Gpu gpu;
  Model model = two_stiff_bars();
  model.gravity.setZero();  // so that the bar beside rests
  Tool ball;
  ball.name = "ball";
  ball.shape = SphereShape{{0, 0, 0}, 0.02};
  ball.path = {{0, {0.2, 0.115, 0.05}, {0, 0, 0}}, {1, {0.5, 0.115, 0.05}, {0, 0, 0}}};  // 5 mm a step
  model.tools = {ball};
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::subspace}));
  GpuSolver again(gpu.programs, model, solver.settings());
  int partial = 0, pressed = 0;
  for (int i = 0; i < 55; ++i) {
    if (i % 5 == 0) {  // in the middle of rounds
      solver.request_check();
      REQUIRE(solver.take_check(true));
      again.upload(solver.download());
      again.request_check();
      REQUIRE(again.take_check(true));
    }
    solver.step();
    again.step();
    partial += !solver.last_was_whole();
    pressed += solver.last_had_contact();
    const State a = solver.download(), b = again.download();
    CAPTURE(i, farthest(a, b), partial, pressed);
    REQUIRE(solver.last_was_whole() == again.last_was_whole());
    REQUIRE(a.displacement == b.displacement);
    REQUIRE(a.velocity == b.velocity);
  }
  CAPTURE(partial, pressed);
  CHECK(partial > 5);
  CHECK(pressed > 40);
}
