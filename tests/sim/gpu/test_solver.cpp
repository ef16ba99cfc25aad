// Properties of whole GPU steps: equilibrium, invariance, conservation, repeatability.
// Covers: solver_record, solver_step
#include <catch2/catch.hpp>
#include <cstring>
#include <thread>

#include "sim/gpu/solver.h"
#include "sim/reference/double_xpbd.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using reference::DoubleXpbd;
using shared::vec4;

namespace {

double largest(const std::vector<Vector3d>& values) {
  double size = 0;
  for (const Vector3d& v : values) size = std::max(size, v.norm());
  return size;
}

}  // namespace

TEST_CASE("rest without gravity is an equilibrium, to the bit", "[gpu]") {
  const double damping = GENERATE(0.0, 0.02);
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  const Model model = free_bar(damping);
  GpuSolver solver(gpu.programs, model, with(pair));
  for (int i = 0; i < 50; ++i) solver.step();
  const State state = solver.download();
  CHECK(largest(state.displacement) == 0);
  CHECK(largest(state.velocity) == 0);
}

TEST_CASE("a rigidly moving body stays rigid", "[gpu]") {
  // A free body in translation.
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  const Model model = free_bar(GENERATE(0.0, 0.02));
  GpuSolver solver(gpu.programs, model, with(pair));
  State state = initial_state(model);
  for (Vector3d& v : state.velocity) v = {0.5, -0.25, 1};
  solver.upload(state);
  for (int i = 0; i < 60; ++i) solver.step();
  const State moved = solver.download();
  for (std::size_t i = 0; i < moved.displacement.size(); ++i) {
    CAPTURE(i, moved.displacement[i].transpose());
    // 60 additions of float32 steps near 1 m
    CHECK((moved.displacement[i] - Vector3d(0.5, -0.25, 1)).norm() < 60 * 1.2e-7);
  }
}

TEST_CASE("the first step waits for unfinished background computations", "[gpu]") {
  Gpu gpu;
  const Model model = bar();
  const auto after_steps = [&](bool wait) {
    GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::subspace}));
    while (wait && !solver.ready()) std::this_thread::yield();
    for (int i = 0; i < 3; ++i) solver.step();
    CHECK(solver.ready());
    CHECK(solver.background_taken() == 0);  // nothing that a replay would have to record
    return solver.buffers().displacement.read<vec4>();
  };
  const auto at_once = after_steps(false), later = after_steps(true);
  REQUIRE(at_once.size() == model.rest_positions.size());
  CHECK(std::memcmp(at_once.data(), later.data(), at_once.size() * sizeof(vec4)) == 0);
}

TEST_CASE("a rotated body at rest feels no force", "[gpu]") {
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  const Model model = free_bar();
  GpuSolver solver(gpu.programs, model, with(pair));
  State state = initial_state(model);
  const double angle = GENERATE(0.1, 1.5, 3.0);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    state.displacement[i] = rotation * model.rest_positions[i] - model.rest_positions[i];
  solver.upload(state);
  for (int i = 0; i < 20; ++i) solver.step();
  const double drift = relative_rms(solver.download().displacement, state.displacement);
  CAPTURE(angle, drift);
  // Strain of rounding, 1e-7 of the displacement gradient. Exact XPBD starts from explicit forces and amplifies short
  // waves before it damps them, so some of it remains after 20 iterations.
  CHECK(drift < (pair.method == Method::exact_xpbd ? 1e-3 : 2e-6));
}

TEST_CASE("a single tet keeps its momentum without gravity", "[gpu]") {
  // With one constraint per vertex averaging has no effect, so the pairs of corrections cancel.
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.12, 0}, {0.02, 0.01, 0.1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.regions = {0};
  Model model = make_model(mesh, tissue(), [](const Vector3d&) { return false; });
  model.gravity.setZero();
  SolverSettings settings = with(pair);
  settings.substeps = 4;
  GpuSolver solver(gpu.programs, model, settings);
  const State state = random_state(model, 0.01, 9);
  solver.upload(state);
  const reference::Measures before = reference::measure(model, state);
  // The corrections of the other methods cancel in pairs up to rounding. The two-level method only reduces the residual
  // to the level of float32, which suffices for a quarter of the time (after 100 steps the momentum is 0.7 percent off,
  // for any number of iterations).
  const int steps = pair.method == Method::two_level ? 25 : 100;
  for (int i = 0; i < steps; ++i) solver.step();
  const reference::Measures after = reference::measure(model, solver.download());
  INFO("before " << before.momentum.transpose() << ", after " << after.momentum.transpose());
  // Up to 400 substeps x 20 iterations of float32 rounding on velocities of 0.1 m/s obtained from differences / h
  CHECK((after.momentum - before.momentum).norm() < 1e-3 * before.momentum.norm());
}

TEST_CASE("the momentum of a mesh drifts exactly as averaging makes it drift", "[gpu]") {
  // Dividing by different valences breaks the symmetry of corrections: a property of the method of the I3D 2019 paper,
  // not of the GPU.
  Gpu gpu;
  const Model model = free_bar();
  GpuSolver solver(gpu.programs, model, with(Method::jacobi));
  DoubleXpbd exact(model, with(Method::jacobi));
  State state = random_state(model, 0.001, 10);
  solver.upload(state);
  for (int i = 0; i < 10; ++i) {
    solver.step();
    exact.step(state);
  }
  const Vector3d got = reference::measure(model, solver.download()).momentum;
  const Vector3d expected = reference::measure(model, state).momentum;
  INFO("got " << got.transpose() << ", expected " << expected.transpose());
  CHECK((got - expected).norm() < 1e-4 * expected.norm());
}

TEST_CASE("the same steps give the same bits: for every run and context, and as on graphics cards if there are no sums",
          "[gpu]") {
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  const auto positions = [&](gl::LoadPath loads, const std::string& context) {
    Gpu gpu(loads, context);
    const Model model = bar(0.01);
    GpuSolver solver(gpu.programs, model, with(pair));
    for (int i = 0; i < 15; ++i) solver.step();
    return solver.buffers().displacement.read<vec4>();
  };
  const auto a = positions(gl::LoadPath::texel, context_names().front());
  const auto same = [&](const std::vector<vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0;
  };
  CHECK(same(positions(gl::LoadPath::texel, context_names().front())));
  CHECK(same(positions(gl::LoadPath::texel, context_names().back())));
  const auto storage = positions(gl::LoadPath::storage, context_names().front());
  if (pair.acceleration == Acceleration::none) CHECK(same(storage));
  // The order of sums over all vertices is that of graphics cards.
  double largest_difference = 0, largest_value = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest_difference = std::max<double>(largest_difference, std::abs(a[i].y - storage[i].y));
    largest_value = std::max<double>(largest_value, std::abs(a[i].y));
  }
  CAPTURE(largest_difference, largest_value);
  CHECK(largest_difference < 1e-3 * largest_value);
}

TEST_CASE("every solver choice repeats bit for bit, with and without readbacks", "[gpu]") {
  const SolverChoice pair = GENERATE(from_range(solver_choices()));
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  if (pair.method == Method::gauss_seidel) settings.colors = GENERATE(0, 6);
  CAPTURE(name_of(pair.method), name_of(pair.acceleration), settings.colors);
  const auto positions = [&](const std::string& context, bool looked_at) {
    Gpu gpu(gl::LoadPath::texel, context);
    const Model model = bar(0.01);
    GpuSolver solver(gpu.programs, model, settings);
    if (looked_at) solver.set_color(ColorBy::von_mises);
    for (int i = 0; i < 10; ++i) {
      solver.step();
      if (!looked_at) continue;
      solver.publish();
      solver.request_diagnostics();
      REQUIRE(solver.take_diagnostics(true));
    }
    return solver.buffers().displacement.read<vec4>();
  };
  const auto a = positions(context_names().front(), false);
  for (const std::string& context : context_names()) {
    const auto b = positions(context, true);
    CAPTURE(context);
    REQUIRE(a.size() == b.size());
    CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0);
  }
}

TEST_CASE("an acceleration that was switched off has no further effect, to the bit", "[gpu]") {
  const Method method = any_method();
  CAPTURE(name_of(method));
  Gpu gpu;
  const Model model = bar();
  const auto run = [&](bool accelerated_before) {
    GpuSolver solver(gpu.programs, model, with(method));
    for (const SolverChoice& pair : solver_choices()) {
      SolverSettings settings = with(pair.method);
      settings.acceleration = pair.acceleration;
      settings.colors = 6;
      if (accelerated_before) solver.set_settings(settings);
      if (accelerated_before) solver.step();
    }
    solver.set_settings(with(method));
    solver.upload(random_state(model, 0.001, 4));
    for (int i = 0; i < 5; ++i) solver.step();
    return solver.download().displacement;
  };
  const auto plain = run(false), after = run(true);
  for (std::size_t i = 0; i < plain.size(); ++i) REQUIRE(plain[i] == after[i]);
}

TEST_CASE("Chebyshev's plain iterations equal the method to the bit", "[gpu]") {
  // The first four of a step have weight 1.
  const Method method = any_method();
  CAPTURE(name_of(method));
  Gpu gpu;
  const Model model = bar();
  const auto run = [&](Acceleration acceleration, int iterations) {
    SolverSettings settings = with(method);
    settings.acceleration = acceleration;
    settings.iterations = iterations;
    GpuSolver solver(gpu.programs, model, settings);
    solver.upload(random_state(model, 0.001, 4));
    solver.step();
    return solver.download().displacement;
  };
  const auto plain = run(Acceleration::none, 4), accelerated = run(Acceleration::chebyshev, 4);
  for (std::size_t i = 0; i < plain.size(); ++i) REQUIRE(plain[i] == accelerated[i]);
  CHECK(relative_rms(run(Acceleration::none, 8), run(Acceleration::chebyshev, 8)) > 1e-6);
}

TEST_CASE("a traced substep equals the substep, and its residual decreases", "[gpu]") {
  Gpu gpu;
  const Model model = bar();
  GpuSolver solver(gpu.programs, model, with(Method::gauss_seidel)),
      leader(gpu.programs, model, with(Method::gauss_seidel));
  leader.upload(random_state(model, 0.001, 4));
  leader.set_grab({{100, {0.01, 0, 0}, 20}, {101, {0.01, 0, 0}, 20}});
  leader.step();
  solver.follow(leader);
  const std::vector<Diagnostics> trace = solver.traced_substep();
  leader.step();
  REQUIRE(trace.size() == 21);
  const auto a = solver.download(), b = leader.download();
  for (std::size_t i = 0; i < a.displacement.size(); ++i) REQUIRE(a.displacement[i] == b.displacement[i]);
  CHECK(a.time == b.time);
  std::vector<double> residuals;
  for (const Diagnostics& d : trace) residuals.push_back(d.residual);
  CAPTURE(residuals);
  CHECK(residuals.front() == Approx(1).epsilon(0.01));
  CHECK(std::is_sorted(residuals.rbegin(), residuals.rend()));
  CHECK(residuals.back() < 0.7);
}

// On GPUs the gradient after a step applies it (sim/gpu/methods/two_level.h).
TEST_CASE("a traced substep by storage blocks equals the substep, and looks at every iteration's state", "[gpu]") {
  struct Case {
    Acceleration acceleration;
    bool mixed, compensated;
  };
  const auto [acceleration, mixed, compensated] = GENERATE(values<Case>({{Acceleration::subspace, false, false},
                                                                         {Acceleration::subspace, true, false},
                                                                         {Acceleration::anderson, false, false},
                                                                         {Acceleration::none, false, true}}));
  CAPTURE(name_of(acceleration), mixed, compensated);
  const Material material{4e4, 0.3, 1000, 0.01, MaterialModel::squared};
  const Model model = mixed ? linear_and_quadratic_bar(4, 0.2, material) : bar(0.01);
  SolverSettings settings = with(SolverChoice{Method::two_level, acceleration});
  settings.iterations = 13;  // includes a refresh
  const State start = random_state(model, 0.001, 4);
  const auto run = [&](gl::LoadPath loads, bool traced) {
    Gpu gpu(loads);
    GpuSolver solver(gpu.programs, model, settings);
    if (compensated) solver.set_compensated(true);
    solver.upload(start);
    solver.set_grab({{10, {0.01, 0, 0}, 20}, {11, {0.01, 0, 0}, 20}});
    solver.step();
    std::vector<Diagnostics> trace;
    if (traced)
      trace = solver.traced_substep();
    else
      solver.step();
    return std::pair(solver.download().displacement, trace);
  };
  const auto [plain, nothing] = run(gl::LoadPath::storage, false);
  const auto [after_trace, trace] = run(gl::LoadPath::storage, true);
  const auto [by_texels, expected] = run(gl::LoadPath::texel, true);
  CHECK(relative_rms(after_trace, plain) == 0);
  CHECK(relative_rms(plain, by_texels) < 1e-5);
  REQUIRE(trace.size() == 14);
  REQUIRE(expected.size() == 14);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    CAPTURE(i);
    CHECK(trace[i].elastic == Approx(expected[i].elastic).epsilon(1e-4));
    if (i > 0) CHECK(trace[i].elastic != trace[i - 1].elastic);
  }
}

TEST_CASE("a hanging bar: stiffer with more iterations, never stiffer than exact by more than rounding", "[gpu]") {
  const Method method = any_method();
  CAPTURE(name_of(method));
  Gpu gpu;
  const Model model = bar(0.02);
  const auto sag = [&](int iterations) {
    SolverSettings settings = with(method);
    settings.iterations = iterations;
    GpuSolver solver(gpu.programs, model, settings);
    for (int i = 0; i < 150; ++i) solver.step();
    double lowest = 0;
    for (const Vector3d& u : solver.download().displacement) lowest = std::min(lowest, u.y());
    return -lowest;
  };
  reference::NewtonSolver newton(model, {});
  State exact = initial_state(model);
  newton.solve_static(exact);
  double exact_sag = 0;
  for (const Vector3d& u : exact.displacement) exact_sag = std::max(exact_sag, -u.y());
  const double few = sag(5), many = sag(40);
  CAPTURE(few, many, exact_sag);
  CHECK(few > many);
  CHECK(many > exact_sag * 0.999);
}

TEST_CASE("mass splitting and Gauss-Seidel keep the momentum of a mesh", "[gpu]") {
  // Every tet's corrections conserve momentum and are applied in full.
  Gpu gpu;
  const Model model = free_bar();
  GpuSolver solver(gpu.programs, model, with(GENERATE(Method::mass_splitting, Method::gauss_seidel)));
  const State state = random_state(model, 0.001, 10);
  solver.upload(state);
  for (int i = 0; i < 30; ++i) solver.step();
  const Vector3d before = reference::measure(model, state).momentum;
  const Vector3d after = reference::measure(model, solver.download()).momentum;
  INFO("before " << before.transpose() << ", after " << after.transpose());
  // 600 sweeps of about 25 float32 corrections per vertex, each rounding at 6e-8 of displacements of 1e-3 m
  CHECK((after - before).norm() < 2e-3 * before.norm());
}

TEST_CASE("shared structures have the same layout in C++ and GLSL", "[gpu]") {
  Gpu gpu;
  const auto offset_of = [](const gl::Program& program, const char* name, GLenum interface) {
    const GLuint index = gl::GetProgramResourceIndex(program.id(), interface, name);
    CAPTURE(name);
    REQUIRE(index != GL_INVALID_INDEX);
    const GLenum property = GL_OFFSET;
    GLint value = -1;
    gl::GetProgramResourceiv(program.id(), interface, index, 1, &property, 1, nullptr, &value);
    return static_cast<std::size_t>(value);
  };
  const gl::Program& predict = gpu.programs.compute("sim/step/predict.comp", {{"MASS_SPLITTING", "0"}});
  CHECK(offset_of(predict, "step_values.gravity", GL_UNIFORM) == offsetof(shared::StepValues, gravity));
  const gl::Program& tet = gpu.programs.compute("sim/readback/diagnose_tet.comp", defines_of(features_of(bar())));
  CHECK(offset_of(tet, "step_values.material", GL_UNIFORM) == offsetof(shared::StepValues, material));
  CHECK(offset_of(tet, "tet_partials[0].sums", GL_BUFFER_VARIABLE) == offsetof(shared::TetPartial, sums));
  const gl::Program& vertex = gpu.programs.compute("sim/readback/diagnose_vertex.comp");
  CHECK(offset_of(vertex, "vertex_partials[0].angular", GL_BUFFER_VARIABLE) ==
        offsetof(shared::VertexPartial, angular));
  CHECK(offset_of(vertex, "vertex_partials[0].residual", GL_BUFFER_VARIABLE) ==
        offsetof(shared::VertexPartial, residual));
}
