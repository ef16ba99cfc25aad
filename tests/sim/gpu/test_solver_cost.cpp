// Costs of GPU steps: sliders rebuild nothing, and unused features have no cost.
// Covers: sim/gpu/passes/features
#include <catch2/catch.hpp>
#include <cstring>
#include <set>

#include "gl/bindings.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using shared::vec4;

TEST_CASE("sliders act on the next step without new buffers or programs", "[gpu]") {
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  Model model = bar();
  GpuSolver solver(gpu.programs, model, with(pair));
  solver.step();
  const std::size_t programs = gpu.programs.size(), bytes = gl::allocated_bytes();
  for (const double young : {1e3, 1e5, 1e9}) {
    model.materials[0].young_modulus = young;
    model.materials[0].density = young / 100;
    solver.materials_changed();
    SolverSettings settings = solver.settings();
    settings.iterations += 5;
    settings.substeps += 1;
    solver.set_settings(settings);
    solver.step();
  }
  CHECK(gpu.programs.size() == programs);
  CHECK(gl::allocated_bytes() == bytes);
  CHECK(solver.settings().iterations == 20 + 15);

  // and the result equals that of a solver created with these values
  Model fresh = model;
  GpuSolver other(gpu.programs, fresh, solver.settings());
  solver.reset();
  solver.finish_background();
  for (int i = 0; i < 5; ++i) {
    solver.step();
    other.step();
  }
  CHECK(relative_rms(solver.download().displacement, other.download().displacement) == 0);
}

// Of nearly 700 if every pass bound all its buffers.
TEST_CASE("buffers that stay at their binding points are not bound again", "[gpu]") {
  Gpu gpu(gl::LoadPath::storage);
  GpuSolver solver(gpu.programs, bar(), with(SolverChoice{Method::two_level, Acceleration::subspace}));
  solver.step();
  const std::uint64_t before = gl::binding_count(), dispatches_before = gl::dispatch_count();
  solver.step();
  const std::uint64_t bindings = gl::binding_count() - before, dispatches = gl::dispatch_count() - dispatches_before;
  CAPTURE(dispatches);
  CHECK(bindings < 150);
}

TEST_CASE("features that are off cost no dispatch, no program and no byte", "[gpu]") {
  Gpu gpu;
  Model plain = bar();
  SolverSettings settings = with(Method::jacobi);
  settings.iterations = 7;
  settings.substeps = 2;
  GpuSolver solver(gpu.programs, plain, settings);
  // predict, 7 x (tets, vertices), velocity, twice
  CHECK(solver.dispatches_per_step() == 2 * (1 + 7 * 2 + 1));
  const std::uint64_t before = gl::dispatch_count();
  solver.step();
  CHECK(gl::dispatch_count() - before == solver.dispatches_per_step());

  const std::size_t bytes = gl::allocated_bytes();
  plain.materials[0].damping = 0.01;
  solver.materials_changed();
  CHECK(solver.dispatches_per_step() == 2 * (2 + 7 * 2 + 1));
  CHECK(gl::allocated_bytes() - bytes == 32 * plain.tets.size());
  const std::size_t with_damping = gl::allocated_bytes();
  const auto bytes_of_slots = [&] {
    const auto& by_buffer = gl::bytes_by_buffer();
    return by_buffer.at("pair_slots") + by_buffer.at("pair_fifth") + by_buffer.at("correction");
  };
  const std::size_t of_pairs = bytes_of_slots();

  solver.set_grab({{40, Vector3d::Zero(), 10}, {41, Vector3d::Zero(), 10}});
  CHECK(solver.dispatches_per_step() == 2 * (2 + 7 * 3 + 1));
  CHECK(gl::allocated_bytes() - with_damping == 2 * (4 + 16 + 16));
  settings.method = Method::gauss_seidel;  // the other method's memory is freed, its own is allocated
  solver.set_settings(settings);
  const std::size_t colors = solver.coloring()->color_count();
  CAPTURE(colors);
  CHECK(solver.dispatches_per_step() == 2 * (2 + 7 * (colors + 1) + 1));
  CHECK(gl::allocated_bytes() - bytes_of_slots() + of_pairs - with_damping == 2 * (4 + 16 + 16));
  const std::size_t plain_bytes = gl::allocated_bytes(), vertices = plain.rest_positions.size();
  settings.acceleration = Acceleration::anderson_positions;
  settings.window = 3;
  solver.set_settings(settings);
  CHECK(solver.dispatches_per_step() == 2 * (2 + 1 + 7 * (colors + 1) + 1 + 6 * 4 + 1));
  CHECK(gl::allocated_bytes() - plain_bytes == 16 * vertices * (3 + 2 * 3) + 16 * 64 * 3 + 4 * 113);
  settings.acceleration = Acceleration::chebyshev;
  solver.set_settings(settings);
  CHECK(solver.dispatches_per_step() == 2 * (2 + 7 * (colors + 1 + 3) + 1));
  CHECK(gl::allocated_bytes() - plain_bytes == 16 * vertices * 2 + 16 * 64 + 4 * 6);
  settings.acceleration = Acceleration::none;
  settings.colors = 5;
  solver.set_settings(settings);
  const std::size_t phantoms = solver.coloring()->phantom_vertex.size();
  CAPTURE(phantoms);
  CHECK(solver.dispatches_per_step() ==
        2 * (2 + 7 * (5 + 2 + 1) + 1));  // including split and merge, the colors and the grab
  CHECK(gl::allocated_bytes() > plain_bytes + 16 * phantoms);
  settings.colors = 0;
  solver.set_settings(settings);
  CHECK(gl::allocated_bytes() == plain_bytes);
  settings.method = Method::jacobi;
  solver.set_settings(settings);
  solver.set_grab({});
  CHECK(solver.dispatches_per_step() == 2 * (2 + 7 * 2 + 1));
  CHECK(gl::allocated_bytes() == with_damping);
}

TEST_CASE("neutral values equal the feature switched off, to the bit", "[gpu]") {
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  const auto run = [&](bool two_equal_materials) {
    Model model = bar();
    if (two_equal_materials) {
      model.materials.push_back(model.materials[0]);
      for (std::size_t t = 0; t < model.tets.size(); t += 2) model.tet_material[t] = 1;
    }
    GpuSolver solver(gpu.programs, model, with(pair));
    for (int i = 0; i < 10; ++i) solver.step();
    return solver.buffers().displacement.read<vec4>();
  };
  const auto same = [](const std::vector<vec4>& a, const std::vector<vec4>& b) {
    if (gl::device().software) return std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0;
    float largest = 0, difference = 0;  // compilers of GPUs contract other kernels in other ways
    for (std::size_t v = 0; v < a.size(); ++v)
      for (const auto& [x, y] : {std::pair(a[v].x, b[v].x), std::pair(a[v].y, b[v].y), std::pair(a[v].z, b[v].z)}) {
        largest = std::max(largest, std::abs(x));
        difference = std::max(difference, std::abs(x - y));
      }
    CAPTURE(difference, largest);
    return difference < 1e-5f * largest;
  };
  const auto off = run(false), neutral = run(true);
  CHECK(same(off, neutral));

  // Damping compiled in with the value zero: one of two materials is damped, but no tet has it.
  Model damped = bar();
  damped.materials.push_back(tissue(0.05));
  GpuSolver solver(gpu.programs, damped, with(pair));
  for (int i = 0; i < 10; ++i) solver.step();
  const auto zero_damping = solver.buffers().displacement.read<vec4>();
  CHECK(same(off, zero_damping));
}

TEST_CASE("a scene with one kind of element pays nothing for the other", "[gpu]") {
  Gpu gpu(gl::LoadPath::storage);
  const Material material{4e4, 0.3, 1000, 0, MaterialModel::squared};
  SolverSettings settings = with(SolverChoice{Method::two_level, Acceleration::subspace});
  settings.iterations = 10;
  settings.rest_speed = 0;
  const std::vector<std::string> of_linear{"pair_fifth", "pair_slots", "tet_begin", "vertex_tets"},
      of_quadratic{"mid_edges", "quadratic_slots", "quadratic_begin", "vertex_quadratic"};
  struct Cost {
    std::uint64_t dispatches;
    std::set<std::string> buffers;
  };
  const auto cost = [&](const Model& model) {
    GpuSolver solver(gpu.programs, model, settings);
    Cost result{solver.dispatches_per_step(), {}};
    for (const auto& [name, bytes] : gl::bytes_by_buffer())
      if (bytes > 0) result.buffers.insert(name);
    solver.step();  // and every eighth one, in which the law squared looks for inverted tets
    const std::uint64_t before = gl::dispatch_count();
    solver.step();
    CHECK(gl::dispatch_count() - before == result.dispatches);
    return result;
  };
  const Cost linear = cost(two_bars(4, 0.2, material)), quadratic_only = cost(quadratic(two_bars(4, 0.2, material))),
             both = cost(linear_and_quadratic_bar(4, 0.2, material));
  for (const std::string& name : of_linear) {
    CAPTURE(name);
    CHECK(linear.buffers.contains(name));
    CHECK_FALSE(quadratic_only.buffers.contains(name));
    CHECK(both.buffers.contains(name));
  }
  for (const std::string& name : of_quadratic) {
    CAPTURE(name);
    CHECK_FALSE(linear.buffers.contains(name));
    CHECK(quadratic_only.buffers.contains(name));
    CHECK(both.buffers.contains(name));
  }
  // What moves at centroids is predicted.
  CHECK(quadratic_only.dispatches == linear.dispatches + 1);
  // Forces at the prediction, in every iteration and at the end; curvatures in every iteration.
  CHECK(both.dispatches == quadratic_only.dispatches + 10 + 2 + 10);
}
