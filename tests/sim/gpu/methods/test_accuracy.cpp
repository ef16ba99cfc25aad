// Results against the exact step: the accuracy of the methods, and the iterations to reach it. The errors are those of
// the step alone, RMS |u - u_exact| over RMS |u_exact - u~|: 1 is the untouched prediction.
// Covers: sim/gpu/static_march
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "sim/gpu/solver.h"
#include "sim/gpu/static_march.h"
#include "sim/grab/build_model.h"
#include "sim/model/vertex_csv.h"
#include "sim/reference/static_residual.h"
#include "sim/scene/scene.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model clamped_beam(int nx, int ny, int nz, double young_modulus, double poisson_ratio = 0.3) {
  return make_model(make_box(nx, ny, nz, {1, 0.25, 0.25}),
                    {young_modulus, poisson_ratio, 1000, 0, MaterialModel::st_venant_kirchhoff},
                    [](const Vector3d& x) { return x.x() < 1e-9; });
}

// Bent, twisted and rough: far from the result of any method.
State disturbed(const Model& model, double spacing) {
  State state = random_state(model, 0.05 * spacing, 7);
  const std::vector<char> held = model.held();
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) continue;
    const Vector3d& x = model.rest_positions[i];
    const double turn = 0.6 * x.x(), y = x.y() - 0.125, z = x.z() - 0.125;
    state.displacement[i] +=
        Vector3d(0.3 * x.x() * x.x() * y, -0.15 * x.x() * x.x() + y * (std::cos(turn) - 1) - z * std::sin(turn),
                 y * std::sin(turn) + z * (std::cos(turn) - 1));
    state.velocity[i].setZero();
  }
  for (Vector3d& u : state.displacement) u = float32_of(u);
  return state;
}

SolverSettings with(const SolverChoice& pair, int iterations) {
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.iterations = iterations;
  return settings;
}

struct Step {
  const Model& model;
  State start, exact;
  double scale = 0;  // of u_exact - u~

  Step(const Model& m, const State& s) : model(m), start(s), exact(s) {
    const SolverSettings settings;
    reference::NewtonSolver(model, settings).step(exact);
    const std::vector<char> held = model.held();
    const double h = settings.time_step;
    for (std::size_t i = 0; i < held.size(); ++i)
      if (!held[i])
        scale += (exact.displacement[i] - start.displacement[i] - h * start.velocity[i] - h * h * model.gravity)
                     .squaredNorm();
  }
  double error(const State& state) const {
    double sum = 0;
    for (std::size_t i = 0; i < state.displacement.size(); ++i)
      sum += (state.displacement[i] - exact.displacement[i]).squaredNorm();
    return std::sqrt(sum / scale);
  }
  double error_of(Gpu& gpu, const SolverSettings& settings) const {
    GpuSolver solver(gpu.programs, model, settings);
    solver.upload(start);
    solver.step();
    return error(solver.download());
  }
};

}  // namespace

TEST_CASE("two levels reach a thousandth of a disturbed step in 20 iterations, for any stiffness", "[gpu]") {
  const double young_modulus = GENERATE(1e5, 1e6, 1e7, 1e9);
  const auto acceleration = GENERATE(Acceleration::nonlinear_cg, Acceleration::subspace);
  CAPTURE(young_modulus, name_of(acceleration));
  Gpu gpu;
  const Model model = clamped_beam(24, 6, 6, young_modulus);
  REQUIRE(model.tets.size() == 5184);
  const Step step(model, disturbed(model, 1.0 / 24));
  const double few = step.error_of(gpu, with({Method::two_level, acceleration}, 20));
  const double many = step.error_of(gpu, with({Method::two_level, acceleration}, 60));
  CAPTURE(few, many);
  CHECK(few < 0.001);
  CHECK(many < 2e-6);  // float32
}

TEST_CASE("grabbed tissue is solved as fast as free tissue", "[gpu]") {
  Gpu gpu;
  const Model model = clamped_beam(24, 6, 6, 1e5);
  std::vector<GrabSpring> springs;  // so stiff that the error is 4 percent if the coarse space ignores them
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.9) springs.push_back({v, {0, 0.05, 0}, 1e4});
  const SolverSettings settings = with({Method::two_level, Acceleration::subspace}, 10);
  GpuSolver solver(gpu.programs, model, settings);
  solver.set_grab(springs);
  solver.step();
  reference::NewtonSolver newton(model, settings);
  newton.set_springs(springs);
  State exact = initial_state(model);
  newton.step(exact);
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(springs.size(), error);
  CHECK(error < 3e-3);
}

// In double precision and on the GPU alike the damping of the drawn-out tets is reduced (damping_share()).
TEST_CASE("a drawn-out bar of the squared law makes the damped step of double precision", "[gpu]") {
  Gpu gpu;
  const double damping = GENERATE(0.0, 0.05, 0.5);
  const double nu = GENERATE(0.3, 0.48);  // of the latter the viscosity has less lambda
  Model model = clamped_beam(10, 3, 3, 1e5);
  model.materials[0].poisson_ratio = nu;
  model.materials[0].model = MaterialModel::squared;
  model.materials[0].damping = damping;
  State state = random_state(model, 2e-3, 7);
  const Vector3d middle = 0.5 * (model.rest_positions.front() + model.rest_positions.back());
  const double lateral = nu > 0.45 ? 1 / std::sqrt(1.8) - 1 : 0;  // keeps the volume
  for (std::size_t v = 0; v < state.displacement.size(); ++v) {
    const Vector3d x = model.rest_positions[v], by = lateral * (x - middle);
    if (x.x() > 0) state.displacement[v] = float32_of(state.displacement[v] + Vector3d(0.8 * x.x(), by.y(), by.z()));
  }
  const Step step(model, state);
  const double error = step.error_of(gpu, with(solver_choices().front(), 100));
  CAPTURE(damping, nu, error);
  CHECK(error < 1e-3);
}

TEST_CASE("every method with an exact fixed point reaches it, and more iterations do not leave it", "[gpu]") {
  // The strain relative to the exact one, which acceleration on positions alone gets wrong.
  struct Case {
    SolverChoice pair;
    int iterations;  // to 0.5 percent of the strain and far less
  };
  const Case c = GENERATE(
      Case{{Method::exact_xpbd, Acceleration::none}, 400}, Case{{Method::exact_xpbd, Acceleration::anderson}, 150},
      Case{{Method::vertex_descent, Acceleration::none}, 400},
      Case{{Method::vertex_descent, Acceleration::anderson}, 100}, Case{{Method::two_level, Acceleration::none}, 200},
      Case{{Method::two_level, Acceleration::anderson}, 50}, Case{{Method::two_level, Acceleration::nonlinear_cg}, 50},
      Case{{Method::two_level, Acceleration::subspace}, 50});
  CAPTURE(name_of(c.pair.method), name_of(c.pair.acceleration));
  Gpu gpu;
  const Model model = clamped_beam(12, 3, 3, 2e5);
  const Step step(model, disturbed(model, 1.0 / 12));
  const double exact_strain = reference::measure(model, step.exact).rms_strain;
  for (const int factor : {1, 3}) {
    GpuSolver solver(gpu.programs, model, with(c.pair, factor * c.iterations));
    solver.upload(step.start);
    solver.step();
    const State state = solver.download();
    const double error = step.error(state), strain = reference::measure(model, state).rms_strain;
    CAPTURE(factor, error, strain, exact_strain);
    CHECK(strain == Approx(exact_strain).epsilon(0.001));
    CHECK(error < 0.005);
  }
}

TEST_CASE("Anderson on positions over-stiffens where Anderson on positions and multipliers does not", "[gpu]") {
  Gpu gpu;
  const Model model = clamped_beam(12, 3, 3, 1e6);
  const Step step(model, disturbed(model, 1.0 / 12));
  const double exact = reference::measure(model, step.exact).rms_strain;
  const auto strain = [&](const SolverChoice& pair) {
    GpuSolver solver(gpu.programs, model, with(pair, 1000));
    solver.upload(step.start);
    solver.step();
    return reference::measure(model, solver.download()).rms_strain;
  };
  const double poster = strain({Method::mass_splitting, Acceleration::anderson_positions});
  const double joint = strain({Method::exact_xpbd, Acceleration::anderson});
  CAPTURE(exact, poster, joint);
  CHECK(poster < 0.95 * exact);
  CHECK(joint == Approx(exact).epsilon(0.001));
}

TEST_CASE("a body 100 m from the origin moves as one at the origin", "[gpu]") {
  Gpu gpu;
  const Model near = clamped_beam(12, 3, 3, 1e6);
  Model far = near;
  for (Vector3d& x : far.rest_positions) x += Vector3d(100, 100, 100);
  const auto run = [&](const Model& model) {
    GpuSolver solver(gpu.programs, model, SolverSettings{});
    for (int i = 0; i < 30; ++i) solver.step();
    return solver.download().displacement;
  };
  const double difference = relative_rms(run(far), run(near));
  CAPTURE(difference);
  CHECK(difference <
        1e-4);  // shapes of tets 0.08 m wide from positions near 100 m, in double; the rest never uses positions
}

TEST_CASE("gravity on a short step is not lost in rounding", "[gpu]") {
  Gpu gpu;
  const Model model = clamped_beam(12, 3, 3, 1e5);
  SolverSettings settings;
  settings.time_step = 1.0 / 600;
  GpuSolver solver(gpu.programs, model, settings);
  solver.step();
  State exact = initial_state(model);
  reference::NewtonSolver(model, settings).step(exact);
  CHECK(relative_rms(solver.download().displacement, exact.displacement) < 1e-5);
}

TEST_CASE("the dynamic reference case with the default settings", "[gpu]") {
  Gpu gpu;
  const std::filesystem::path folder = source_dir() / "tests/reference/10_dynamic_cantilever";
  const Scene scene = open_scene(folder / "scene.json");
  const Model model = build_model(scene);
  const bool tight = GENERATE(false, true);
  SolverSettings settings;  // the defaults, which this case tests
  settings.time_step = scene.solver.time_step;
  if (tight) {
    settings.tolerance = 1e-5;
    settings.iterations = 100;
  }
  GpuSolver solver(gpu.programs, model, settings);
  int done = 0;
  for (const int step : {1, 10, 30, 60}) {
    for (; done < step; ++done) solver.step();
    std::vector<Vector3d> exact = read_complete_vertex_csv(
        folder / ("reference_h60_step" + std::to_string(step) + ".csv"), model.rest_positions.size());
    for (std::size_t i = 0; i < exact.size(); ++i) exact[i] -= model.rest_positions[i];
    const double error = relative_rms(solver.download().displacement, exact);
    CAPTURE(tight, step, error);
    CHECK(error < (step == 1 ? 1e-4 : 3e-5));  // at rest, the inertial start does not include gravity
  }
}

TEST_CASE("the dynamic reference case with BDF2", "[gpu]") {
  Gpu gpu;
  const std::filesystem::path folder = source_dir() / "tests/reference/10_dynamic_cantilever";
  const Model model = build_model(open_scene(folder / "scene.json"));
  SolverSettings settings;
  settings.integrator = Integrator::bdf2;
  GpuSolver solver(gpu.programs, model, settings);
  for (int step = 0; step < 60; ++step) solver.step();
  std::vector<Vector3d> exact =
      read_complete_vertex_csv(folder / "reference_bdf2_h60_step60.csv", model.rest_positions.size());
  for (std::size_t i = 0; i < exact.size(); ++i) exact[i] -= model.rest_positions[i];
  const double error = relative_rms(solver.download().displacement, exact);
  CAPTURE(error);
  CHECK(error < 3e-5);
}

TEST_CASE("static equilibria of the reference cases on the GPU with the default settings", "[gpu]") {
  Gpu gpu;
  const std::string name =
      GENERATE("01_cantilever_small", "02_cantilever_large", "05_stretch_150", "09a_affine_compression");
  const std::filesystem::path folder = source_dir() / "tests/reference" / name;
  const Scene scene = open_scene(folder / "scene.json");
  const Model model = build_model(scene);
  GpuSolver solver(gpu.programs, model, SolverSettings{});
  State state;
  const reference::NewtonReport report = march_to_equilibrium(solver, model, {1e-5}, state);
  CHECK(!solver.buffers().displacement_low);
  std::vector<Vector3d> exact = read_complete_vertex_csv(folder / "reference.csv", model.rest_positions.size());
  double error = 0, size = 0;  // over the vertices whose motion the scene does not prescribe
  const std::vector<char> held = model.held();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (held[i]) continue;
    error += (state.displacement[i] + model.rest_positions[i] - exact[i]).squaredNorm();
    size += (exact[i] - model.rest_positions[i]).squaredNorm();
  }
  error = std::sqrt(error / size);
  CAPTURE(name, report.iterations, report.relative_residual, error);
  CHECK(report.converged);
  CHECK(report.relative_residual <= 1e-5);
  CHECK(reference::StaticResidual(model)(state) == report.relative_residual);
  CHECK(error < 1e-5);
}

TEST_CASE("a march to equilibrium that is stopped early restores settings and grabs", "[gpu]") {
  Gpu gpu;
  const Model model =
      make_model(make_box(6, 2, 2, {0.3, 0.1, 0.1}), {1e5, 0.3, 1000}, [](const Vector3d& x) { return x.x() < 1e-9; });
  GpuSolver solver(gpu.programs, model, SolverSettings{});
  const std::vector<GrabSpring> grab{{static_cast<std::uint32_t>(model.rest_positions.size() - 1), {0, 0.2, 0}, 1e4}};
  solver.set_grab(grab);
  const bool throws = GENERATE(false, true);
  CAPTURE(throws);
  std::stop_source stop;
  State state;
  const auto march = [&] {
    march_to_equilibrium(solver, model, {1e-5}, state, stop.get_token(), [&](const reference::NewtonReport&) {
      if (throws) throw std::runtime_error("enough");
      stop.request_stop();
    });
  };
  if (throws)
    CHECK_THROWS_AS(march(), std::runtime_error);
  else
    march();
  CHECK(solver.settings() == SolverSettings{});
  CHECK(solver.springs() == grab);
  CHECK_FALSE(solver.buffers().displacement_low);
  solver.step();
  CHECK(solver.download().displacement.front().allFinite());
}
