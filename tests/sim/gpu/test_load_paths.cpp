// Kernels that read by texels compute what those do that read storage blocks, to the bit, with the order of sums that
// the device has and with that of graphics cards. No method, acceleration or feature is an exception.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/gpu/kernel_cases.h"
#include "tests/support/touching_bodies.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

/// Both load paths with one order of sums.
struct Paths {
  explicit Paths(bool as_graphics_cards)
      : context(make_context({context_names().front()})),
        sums(as_graphics_cards ? gl::Sums::in_groups : gl::fitting_sums()),
        blocks(source_dir() / "shaders", gl::LoadPath::storage, sums),
        texels(source_dir() / "shaders", gl::LoadPath::texel, sums) {}
  std::unique_ptr<Context> context;
  gl::Sums sums;
  gl::ProgramCache blocks, texels;
};

const Material kDamped{2e4, 0.45, 1000, 0.01, MaterialModel::signed_st_venant_kirchhoff};
const Material kSquared{2e4, 0.4, 1000, 0.02, MaterialModel::squared};

SolverSettings settings_of(const SolverChoice& choice, int iterations = 6) {
  SolverSettings settings = frames();
  settings.method = choice.method;
  settings.acceleration = choice.acceleration;
  settings.iterations = iterations;
  settings.rest_speed = 0;
  return settings;
}

const SolverChoice kBest{Method::two_level, Acceleration::subspace};

// 864 tets of two materials that fall and swing, with several clusters of forces and partial sums.
Model swinging_bar() {
  Model model = make_model(make_box(16, 3, 3, {0.4, 0.1, 0.1}), kDamped, at_left_end);
  model.materials.push_back({8e4, 0.3, 1200, 0, MaterialModel::st_venant_kirchhoff});
  for (std::size_t t = 0; t < model.tets.size() / 3; ++t) model.tet_material[t] = 1;
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    if (!model.held()[v]) model.initial_velocity[v] = Vector3d(0, 0, 2 * model.rest_positions[v].x());
  return model;
}

Model half_quadratic_bars() {
  Model model = beside(swinging_bar(), moved(swinging_bar(), {0, 0.3, 0}), "quadratic");
  model.contact.bodies = false;
  const auto half = static_cast<std::uint32_t>(model.tets.size() / 2);
  return quadratic(std::move(model), half);
}

Tool tool_of(const std::string& name, const ToolShape& shape, std::vector<Instrument::Key> path) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.friction = 0.4;
  tool.path = std::move(path);
  return tool;
}

// A cube that slides on a slab, with a ball that presses on both sides of its edge.
Model pressed_cube() {
  Model model = cube_on_slope(0.3, 0.3, kSquared);
  model.tools = {tool_of("ball", SphereShape{{0, 0, 0}, 0.04},
                         {{0, {0.37, 0.25, 0.125}, {0, 0, 0}}, {0.2, {0.3, 0.22, 0.14}, {0, 0, 0}}})};
  return model;
}

// Stands on its end and bends under its weight.
Model column(std::array<int, 3> cells, const Vector3d& size, double young_modulus) {
  Model model = make_model(make_box(cells[0], cells[1], cells[2], size), {young_modulus, 0.45, 1000, 0},
                           [](const Vector3d& x) { return x.y() < 1e-9; });
  model.gravity = {0, -9.81, 0};
  return model;
}

struct Run {
  State state;
  Diagnostics numbers;
};

struct Steps {
  int count = 5;
  bool hand = false;  // pulls the last vertex, ever farther
};

Run after_steps(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings, const Steps& steps) {
  GpuSolver solver(programs, model, settings);
  solver.finish_background();
  const auto tip = static_cast<std::uint32_t>(model.rest_positions.size() - 1);
  Run run;
  for (int step = 0; step < steps.count; ++step) {
    if (steps.hand) solver.set_grab({{tip, {0, 0.01 * step, 0.01}, 200}, {tip - 1, {0, 0.01 * step, 0}, 200}});
    solver.step();
  }
  solver.request_diagnostics();
  run.numbers = *solver.take_diagnostics(true);
  run.state = solver.download();
  return run;
}

Run check_paths(Paths& paths, const Model& model, const SolverSettings& settings, const Steps& steps = {}) {
  const Run blocks = after_steps(paths.blocks, model, settings, steps),
            texels = after_steps(paths.texels, model, settings, steps);
  REQUIRE(largest_displacement(blocks.state) > 0.01);
  CHECK(differences(blocks.state, texels.state) == 0);
  CHECK(blocks.numbers.residual == texels.numbers.residual);
  CHECK(blocks.numbers.elastic == texels.numbers.elastic);
  REQUIRE(blocks.numbers.tool_loads.size() == texels.numbers.tool_loads.size());
  for (std::size_t k = 0; k < blocks.numbers.tool_loads.size(); ++k)
    CHECK(blocks.numbers.tool_loads[k].force == texels.numbers.tool_loads[k].force);
  REQUIRE(blocks.numbers.pair_loads.size() == texels.numbers.pair_loads.size());
  for (std::size_t k = 0; k < blocks.numbers.pair_loads.size(); ++k)
    CHECK(blocks.numbers.pair_loads[k].force == texels.numbers.pair_loads[k].force);
  return blocks;
}

void check_every_kernel(bool as_graphics_cards) {
  Paths paths(as_graphics_cards);
  for (const KernelCase& example : kernel_cases()) {
    CAPTURE(example.name);
    const auto states = [&](gl::ProgramCache& programs) {
      std::vector<State> all;
      run_all(example, programs, [&](GpuSolver& solver) { all.push_back(solver.download()); });
      return all;
    };
    const std::vector<State> blocks = states(paths.blocks), texels = states(paths.texels);
    REQUIRE(blocks.size() == texels.size());
    for (std::size_t k = 0; k < blocks.size(); ++k) CHECK(differences(blocks[k], texels[k]) == 0);
  }
}

}  // namespace

TEST_CASE("states are the same to the bit by storage blocks and by texels", "[gpu]") {
  Paths paths(GENERATE(false, true));
  CAPTURE(paths.blocks.sums_in_groups());
  SECTION("with every method and acceleration") {
    for (const SolverChoice& choice : solver_choices()) {
      CAPTURE(name_of(choice.method), name_of(choice.acceleration));
      check_paths(paths, swinging_bar(), settings_of(choice), {5, true});
    }
  }
  SECTION("with every acceleration of two_level") {
    for (const Acceleration acceleration : info_of(Method::two_level).accelerations) {
      SolverSettings settings = settings_of({Method::two_level, acceleration});
      CAPTURE(name_of(acceleration));
      check_paths(paths, half_quadratic_bars(), settings, {3, true});
      const Run pressed = check_paths(paths, pressed_cube(), settings, {8, true});
      CHECK(pressed.numbers.tool_loads.front().points > 0);
      CHECK(pressed.numbers.pair_loads.size() == 1);
      settings.tolerance = 1e-4;
      check_paths(paths, swinging_bar(), settings);
    }
  }
}

TEST_CASE("every kernel gives the same states by storage blocks and by texels", "[gpu]") { check_every_kernel(false); }
TEST_CASE("every kernel of graphics cards gives the same states by storage blocks and by texels", "[gpu][slow]") {
  check_every_kernel(true);
}

// Their motion amplifies rounding a thousandfold and more.
TEST_CASE("columns that buckle have the same states by storage blocks and by texels", "[gpu]") {
  Paths paths(false);
  const SolverSettings settings = settings_of(kBest, 10);
  const Model linear = column({3, 24, 3}, {0.04, 0.5, 0.04}, 3e4);
  const Run run = check_paths(paths, linear, settings, {90});
  gl::ProgramCache others(source_dir() / "shaders", gl::LoadPath::texel,
                          paths.sums == gl::Sums::in_groups ? gl::Sums::in_invocations : gl::Sums::in_groups);
  CHECK(farthest(run.state, after_steps(others, linear, settings, {90}).state) > 1e-4);
  check_paths(paths, quadratic(column({2, 12, 2}, {0.04, 0.5, 0.04}, 2e4)), settings, {60});
  Model folds = column({2, 14, 2}, {0.03, 0.25, 0.03}, 4e3);
  folds.contact.self = true;
  folds.tools = {tool_of("ground", PlaneShape{{0, -0.01, 0}, {0, 1, 0}}, {{}})};
  const Run folded = check_paths(paths, folds, settings, {22});
  CHECK(folded.numbers.tool_loads.front().points > 0);
  CHECK(folded.numbers.pair_loads.size() == 1);
}
