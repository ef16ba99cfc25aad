// The test of boxes: never late, whatever brings tissue and tools together, and rarely reading.
#include "sim/gpu/contact/tool_watch.h"

#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/tool/shape_distance.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kSize = 0.2;

Model watched_cube(bool held) {
  Material material;
  material.young_modulus = 2e4;
  Model model = test::make_model(make_box(3, 3, 3, {kSize, kSize, kSize}), material,
                                 [&](const Vector3d& x) { return held && x.y() > kSize - 1e-9; });
  model.gravity = {0, -9.81, 0};
  return model;
}

Tool watched_tool(const ToolShape& shape, std::vector<Instrument::Key> path) {
  Tool tool;
  tool.name = "tool";
  tool.shape = shape;
  tool.friction = 0.3;
  tool.path = std::move(path);
  return tool;
}

SolverSettings watched_settings() {
  SolverSettings settings;
  settings.time_step = 1.0 / 60;
  settings.rest_speed = 0;
  return settings;
}

// As the kernels look for points that may touch (shaders/sim/contact/contact_near.comp), but with vertices.
bool may_touch(const Model& model, const State& state, const ToolMotion& motion, double h, double size) {
  for (std::size_t v = 0; v < state.displacement.size(); ++v) {
    const Vector3d x = model.rest_positions[v] + state.displacement[v],
                   way = h * state.velocity[v] + h * h * model.gravity;
    for (std::size_t t = 0; t < model.tools.size(); ++t) {
      const double d = distance_to(model.tools[t].shape, motion.from[t].pose.to_local(x)).distance,
                   moves = (motion.to[t].pose.origin - motion.from[t].pose.origin).norm();
      if (d < 2 * way.norm() + moves + 0.02 * size) return true;
    }
  }
  return false;
}

struct Seen {
  int steps = 0, needed = 0, near = 0, readings = 0;
};

// Whether steps have contact where they need it.
Seen watch(Model model, const Vector3d& velocity, int steps,
           const std::function<std::vector<GrabSpring>(int)>& springs = {}) {
  test::Gpu gpu;
  GpuSolver solver(gpu.programs, model, watched_settings());
  State state = initial_state(model);
  for (Vector3d& v : state.velocity) v = velocity;
  solver.upload(state);
  Seen seen;
  for (int i = 0; i < steps; ++i) {
    if (springs) solver.set_grab(springs(i));
    const State before = solver.download();
    const double h = solver.settings().time_step;
    const bool needed =
        may_touch(model, before, motion_on_paths(model.tools, before.time, before.time + h), h, solver.buffers().size);
    const std::uint64_t dispatches = gl::dispatch_count();
    solver.step();
    seen.readings += gl::dispatch_count() - dispatches > solver.dispatches_per_step();
    INFO("step " << i);
    CHECK((!needed || solver.last_had_contact()));
    seen.needed += needed;
    seen.near += solver.last_had_contact();
    ++seen.steps;
  }
  return seen;
}

TEST_CASE("tissue that falls or is thrown has contact in time", "[gpu][contact]") {
  const Vector3d velocity = GENERATE(Vector3d(0, 0, 0), Vector3d(0, -4, 0), Vector3d(0, -20, 0));
  Model model = watched_cube(false);
  model.tools = {watched_tool(PlaneShape{{0, -1, 0}, {0, 1, 0}}, {{}})};
  const Seen seen = watch(model, velocity, 36);
  CAPTURE(velocity.transpose(), seen.needed, seen.near, seen.readings);
  CHECK(seen.needed > 0);
  CHECK(seen.near < seen.steps);
}

TEST_CASE("tools that come fast or jump have contact in time", "[gpu][contact]") {
  Model model = watched_cube(true);
  model.tools = {watched_tool(SphereShape{{0, 0, 0}, 0.06}, {{0, {0.1, -1, 0.1}, {0, 0, 0}},
                                                             {0.295, {0.1, -0.8, 0.1}, {0, 0, 0}},
                                                             {0.3, {0.1, 0.02, 0.1}, {0, 0, 0}},
                                                             {0.4, {0.1, 0.02, 0.1}, {0, 0, 0}},
                                                             {0.405, {0.1, -1, 0.1}, {0, 0, 0}},
                                                             {1, {0.1, -0.5, 0.1}, {0, 0, 0}}})};
  const Seen seen = watch(model, {0, 0, 0}, 60);
  CAPTURE(seen.needed, seen.near, seen.readings);
  CHECK(seen.needed > 5);
  CHECK(seen.near < 30);
  CHECK(seen.readings < 20);
}

TEST_CASE("tissue that a hand pulls to a tool, and lets go, has contact in time", "[gpu][contact]") {
  Model model = watched_cube(true);
  model.tools = {watched_tool(BoxShape{{0, 0, 0}, {0.05, 0.05, 0.05}, 0.01}, {{0, {0.1, -0.4, 0.1}, {0, 0, 0}}})};
  std::uint32_t corner = 0;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if ((model.rest_positions[v] - Vector3d(kSize / 3, 0, kSize / 3)).norm() < 1e-9) corner = v;
  const auto pull = [&](int step) -> std::vector<GrabSpring> {
    if (step < 10 || step > 40) return {};
    return {{corner, {0.03, step < 15 ? -0.1 : -0.36, 0.03}, 1e6}};
  };
  const Seen seen = watch(model, {0, 0, 0}, 60, pull);
  CAPTURE(seen.needed, seen.near, seen.readings);
  CHECK(seen.needed > 5);
  CHECK(seen.near < seen.steps);
}

}  // namespace
}  // namespace fascia
