// Quadratic tets on the GPU, against the reference solver in double precision: one step of every law, motion, strain
// rates, heat maps, scenes with linear bodies beside quadratic ones, and what the GPU refuses.
#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "sim/gpu/methods/two_level.h"
#include "sim/gpu/solver.h"
#include "sim/material/law.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model quadratic_bar(const Material& material) {
  return quadratic(
      make_model(make_box(4, 2, 2, {0.2, 0.06, 0.06}), material, [](const Vector3d& x) { return x.x() < 1e-9; }));
}

Model quadratic_bar(MaterialModel model, double poisson_ratio = 0.3, double damping = 0) {
  Material material{2e4, poisson_ratio, 1000, damping, model};
  return quadratic_bar(material);
}

SolverSettings settings_with(int iterations) {
  SolverSettings settings;
  settings.iterations = iterations;
  settings.rest_speed = 0;
  return settings;
}

void run_all(const Passes& passes) {
  for (const gl::ComputePass& pass : passes) pass.run();
}

double error_after(Gpu& gpu, const Model& model, const SolverSettings& settings, int steps) {
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  for (int k = 0; k < steps; ++k) {
    solver.step();
    const reference::NewtonReport report = reference.step(exact);
    CAPTURE(k, report.iterations, report.relative_residual);
    REQUIRE(report.converged);
  }
  return relative_rms(solver.download().displacement, exact.displacement);
}

}  // namespace

TEST_CASE("quadratic tets of every law follow the reference solver, damped or not", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const MaterialModel law = GENERATE(from_range(material_models()));
  const double damping = GENERATE(0.0, 0.02);
  Gpu gpu(loads);
  const double error = error_after(gpu, quadratic_bar(law, 0.3, damping), settings_with(60), 6);
  CAPTURE(name_of(law), damping, error);
  CHECK(error < 1e-6);  // a few roundings of float32
}

TEST_CASE("nearly incompressible quadratic tets of every law are damped as by the reference solver", "[gpu]") {
  const MaterialModel law = GENERATE(from_range(material_models()));
  Gpu gpu;
  const double error = error_after(gpu, quadratic_bar(law, 0.49, 0.02), settings_with(150), 6);
  CAPTURE(name_of(law), error);
  CHECK(error < 1e-5);
}

TEST_CASE("quadratic tets follow the reference solver with the default settings", "[gpu]") {
  const auto [nu, most] = GENERATE(table<double, double>({{0.0, 1e-4}, {0.3, 1e-4}, {0.45, 1.5e-3}, {0.49, 1e-2}}));
  const auto integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  Gpu gpu;
  SolverSettings settings = settings_with(10);
  settings.integrator = integrator;
  const double error = error_after(gpu, quadratic_bar(MaterialModel::squared, nu, 0.005), settings, 12);
  CAPTURE(nu, name_of(integrator), error);
  CHECK(error < most);
}

TEST_CASE("a nearly incompressible beam of quadratic tets follows a hand with eight iterations", "[gpu]") {
  Gpu gpu;
  const Material material{2.5e5, 0.49, 1000, 0, MaterialModel::signed_st_venant_kirchhoff};
  const Model model = quadratic(
      make_model(make_box(8, 2, 2, {0.4, 0.1, 0.1}), material, [](const Vector3d& x) { return x.x() < 1e-9; }));
  const SolverSettings settings = settings_with(8);
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  std::vector<Vector3d> reached, expected;  // of all steps
  for (int k = 0; k < 30; ++k) {
    const Vector3d pull = std::min(1.0, (k + 1) / 6.0) * Vector3d(-0.05, 0.02, 0.12);
    std::vector<GrabSpring> springs;
    for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
      if (model.rest_positions[v].x() > 0.4 - 1e-9) springs.push_back({v, pull, 160});
    solver.set_grab(springs);
    reference.set_springs(springs);
    solver.step();
    REQUIRE(reference.step(exact).converged);
    const State state = solver.download();
    reached.insert(reached.end(), state.displacement.begin(), state.displacement.end());
    expected.insert(expected.end(), exact.displacement.begin(), exact.displacement.end());
  }
  const double error = relative_rms(reached, expected);
  CAPTURE(error);
  CHECK(error < 0.01);
}

TEST_CASE("quadratic tets with two materials and a grab follow the reference solver", "[gpu]") {
  Gpu gpu;
  Model model = quadratic_bar(MaterialModel::signed_st_venant_kirchhoff);
  model.materials.push_back({2e5, 0.4, 1200, 0.01, MaterialModel::squared});
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material[t] = t % 3 == 0;
  const SolverSettings settings = settings_with(80);
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.2 - 1e-9) springs.push_back({v, {0.02, 0.03, 0.01}, 20});
  solver.set_grab(springs);
  reference.set_springs(springs);
  for (int k = 0; k < 6; ++k) {
    solver.step();
    REQUIRE(reference.step(exact).converged);
  }
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(error);
  CHECK(error < 2e-6);
}

TEST_CASE("quadratic tets follow the reference solver where the support shakes", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  Gpu gpu(loads);
  Model model = quadratic_bar(MaterialModel::squared);
  shake_fixed(model);
  SolverSettings settings = settings_with(60);
  settings.integrator = integrator;
  const double error = error_after(gpu, model, settings, 10);
  CAPTURE(gl::name_of(loads), name_of(integrator), error);
  CHECK(error < 2e-6);
}

TEST_CASE("a state in the middle of a motion continues as if it had never been left", "[gpu]") {
  Gpu gpu;
  Model model = quadratic_bar(MaterialModel::squared);
  Motion shake;
  shake.vertices = std::exchange(model.fixed, {});
  shake.translate = {0.02, 0.05, 0};
  shake.duration = 0.2;
  model.motions = {shake};
  SolverSettings settings = settings_with(10);
  settings.integrator = Integrator::bdf2;
  GpuSolver solver(gpu.programs, model, settings), second(gpu.programs, model, settings);
  for (int k = 0; k < 4; ++k) solver.step();
  second.upload(solver.download());
  for (int k = 0; k < 4; ++k) {
    solver.step();
    second.step();
  }
  const State one = solver.download(), other = second.download();
  CHECK(relative_rms(other.displacement, one.displacement) == 0);
  CHECK(relative_rms(other.velocity, one.velocity) == 0);
}

TEST_CASE("diagnostics of quadratic tets are the reference solver's measures", "[gpu]") {
  Gpu gpu;
  Model model = quadratic_bar(MaterialModel::squared, 0.4);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 1e-9) model.initial_velocity[v] = {0.1, 2 * model.rest_positions[v].x(), 0.3};
  GpuSolver solver(gpu.programs, model, settings_with(20));
  for (int k = 0; k < 8; ++k) solver.step();
  solver.request_diagnostics();
  const Diagnostics d = *solver.take_diagnostics(true);
  const reference::Measures exact = reference::measure(model, solver.download());
  CHECK(d.elastic == Approx(exact.elastic).epsilon(1e-4));
  CHECK(d.kinetic == Approx(exact.kinetic).epsilon(1e-5));
  CHECK((d.momentum - exact.momentum).norm() < 1e-5 * exact.momentum.norm());
  CHECK((d.angular_momentum - exact.angular_momentum).norm() < 1e-5 * exact.angular_momentum.norm());
  CHECK((d.reaction - exact.fixed_reaction).norm() < 1e-4 * exact.fixed_reaction.norm());
  CHECK(d.min_det_f == Approx(exact.min_det_f).epsilon(1e-4));
  CHECK(d.max_det_f == Approx(exact.max_det_f).epsilon(1e-4));
  CHECK(d.volume_ratio == Approx(exact.volume_ratio).epsilon(1e-5));
  CHECK(d.inverted == exact.inverted);
  double mass = 0;
  for (const double m : lumped_masses(model)) mass += m;
  CAPTURE(d.inertia.transpose(), d.reaction.transpose(), d.residual);
  CHECK(d.imbalance(mass * model.gravity) < 1e-3);
}

TEST_CASE("linear and quadratic bodies in one scene follow the reference solver", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const auto [law, damping, iterations, most] = GENERATE(
      table<MaterialModel, double, int, double>({{MaterialModel::squared, 0.0, 12, 1.5e-4},
                                                 {MaterialModel::squared, 0.0, 24, 1e-5},
                                                 {MaterialModel::squared, 0.02, 40, 1e-6},
                                                 {MaterialModel::signed_st_venant_kirchhoff, 0.02, 40, 1e-6}}));
  Gpu gpu(loads);
  const Model model = linear_and_quadratic_bar(6, 0.3, {4e4, 0.3, 1000, damping, law});
  const SolverSettings settings = settings_with(iterations);
  GpuSolver solver(gpu.programs, model, settings);
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, settings);
  for (int k = 0; k < 10; ++k) {
    solver.step();
    REQUIRE(reference.step(exact).converged);
  }
  const State state = solver.download();
  std::array<std::vector<Vector3d>, 2> moved, expected;  // by body
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    const bool second = model.rest_positions[v].y() > 0.2;
    moved[second].push_back(state.displacement[v]);
    expected[second].push_back(exact.displacement[v]);
  }
  const double of_linear = relative_rms(moved[0], expected[0]), of_quadratic = relative_rms(moved[1], expected[1]);
  CAPTURE(gl::name_of(loads), name_of(law), damping, of_linear, of_quadratic);
  CHECK(of_linear < most);
  CHECK(of_quadratic < most);
  CHECK(moved[1].size() > 4 * moved[0].size());

  solver.request_diagnostics();
  const Diagnostics d = *solver.take_diagnostics(true);
  const reference::Measures measures = reference::measure(model, state);
  CHECK(d.elastic == Approx(measures.elastic).epsilon(1e-4));
  CHECK(d.kinetic == Approx(measures.kinetic).epsilon(1e-4));
  CHECK(d.min_det_f == Approx(measures.min_det_f).epsilon(1e-4));
  CHECK(d.max_det_f == Approx(measures.max_det_f).epsilon(1e-4));
  CHECK(d.volume_ratio == Approx(measures.volume_ratio).epsilon(1e-5));
}

TEST_CASE("tets of both kinds may meet at a vertex", "[gpu]") {
  Gpu gpu;
  const Material material{2e4, 0.3, 1000, 0.01, MaterialModel::squared};
  Model model =
      make_model(make_box(4, 2, 2, {0.2, 0.06, 0.06}), material, [](const Vector3d& x) { return x.x() < 1e-9; });
  const auto half = static_cast<std::uint32_t>(model.tets.size() / 2);
  const double error = error_after(gpu, quadratic(std::move(model), half), settings_with(300), 6);
  CAPTURE(error);
  CHECK(error < 1e-6);
}

TEST_CASE("deferred quadratic tets take part in a step like the others", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const bool mixed = GENERATE(false, true);
  const Material material{2e4, 0.3, 1000, 0.01, MaterialModel::signed_st_venant_kirchhoff};
  Gpu gpu(loads);
  const Model model =
      mixed ? linear_and_quadratic_bar(4, 0.2, material) : quadratic_bar(MaterialModel::signed_st_venant_kirchhoff);
  const SolverSettings settings = settings_with(10);
  const EnergyTerms terms;
  const gl::Buffer no_strain;
  std::array<std::vector<Vector3d>, 2> reached;
  std::uint32_t deferred_count = 0;
  for (const bool defers : {false, true}) {
    SimBuffers buffers(model);
    buffers.upload_step(model, settings, IntegratorStage{settings.substep()});
    buffers.upload_state(model, random_state(model, 0.004, 9));
    prediction(gpu.programs, buffers, nullptr, {false}).run();
    Features features = features_of(model);
    features.damping = false;
    TwoLevelMethod method(gpu.programs, model, buffers, settings);
    method.complete();
    std::optional<DeferredTets> deferred;
    Recording recording{gpu.programs, buffers, features, no_strain, terms};
    const Passes blocks = method.refresh(recording);
    if (defers) recording.deferred = &deferred.emplace(method.most_deferred(buffers, false));
    method.prepare(recording);
    run_all(method.begin(recording));
    run_all(blocks);
    for (const bool first : {true, false}) {
      run_all(method.before(recording, first));
      run_all(method.iteration(recording, first));
    }
    run_all(method.complete_iteration(recording));
    reached[defers] = buffers.download_vectors(buffers.displacement);
    if (!defers) continue;
    deferred_count = deferred->count();
    const std::uint32_t items = buffers.pair_and_single_count() + buffers.quadratic_count;
    CAPTURE(items, deferred_count);
    CHECK(deferred_count > items / 20);
    CHECK(deferred_count < items);
  }
  const double difference = relative_rms(reached[1], reached[0]);
  CAPTURE(gl::name_of(loads), mixed, difference, deferred_count);
  CHECK(difference < 1e-4);
}

TEST_CASE("heat maps of a scene with both kinds of tets are those of each alone", "[gpu]") {
  const ColorBy color = GENERATE(ColorBy::von_mises, ColorBy::strain);
  Gpu gpu;
  const Material material{4e4, 0.3, 1000, 0, MaterialModel::squared};
  const auto key = [](const Vector3d& x) { return std::array{x.x(), x.y(), x.z()}; };
  using Places = std::map<std::array<double, 3>, std::size_t>;
  const auto places = [&](const Model& model) {
    Places at;
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v) at[key(model.rest_positions[v])] = v;
    return at;
  };
  const Model both = linear_and_quadratic_bar(4, 0.2, material);
  const State state = random_state(both, 1e-3, 3);
  const Places at_both = places(both);
  const auto values = [&](const Model& model) {
    State same = initial_state(model);
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
      if (const auto found = at_both.find(key(model.rest_positions[v])); found != at_both.end())
        same.displacement[v] = state.displacement[found->second];
    GpuSolver solver(gpu.programs, model, settings_with(5));
    solver.upload(same);
    solver.set_color(color);
    solver.publish();
    std::vector<float> scalars;
    for (const shared::vec4& p : solver.positions().read<shared::vec4>()) scalars.push_back(p.w);
    return scalars;
  };
  const Model linear = two_bars(4, 0.2, material), all_quadratic = quadratic(two_bars(4, 0.2, material));
  const std::vector<float> mixed = values(both), of_linear = values(linear), of_quadratic = values(all_quadratic);
  const Places at_linear = places(linear), at_quadratic = places(all_quadratic);
  for (const auto& [x, v] : at_both) {
    const bool second = x[1] > 0.2;
    CAPTURE(v, second);
    const float expected = second ? of_quadratic[at_quadratic.at(x)] : of_linear[at_linear.at(x)];
    REQUIRE(mixed[v] == Approx(expected).epsilon(1e-5));
  }
}

TEST_CASE("surfaces in quadratic tets are drawn by their shape functions", "[gpu]") {
  const bool mixed = GENERATE(false, true);
  Gpu gpu;
  const Model model = mixed ? linear_and_quadratic_bar(3, 0.2, {4e4, 0.3, 1000, 0, MaterialModel::squared})
                            : quadratic_bar(MaterialModel::squared);
  const State state = random_state(model, 1e-3, 5);
  const std::vector<Vector3d> points{
      {0.031, 0.017, 0.022}, {0.11, 0.029, 0.05}, {0.19, 0.034, 0.07}, {0.12, 0.33, 0.04}};
  const EmbeddedPoints drawn = embed(points, model.rest_positions, model.tets, model.mid_edges);
  GpuSolver solver(gpu.programs, model, settings_with(5), drawn);
  solver.upload(state);
  solver.publish();
  const std::vector<shared::vec4> positions = solver.positions().read<shared::vec4>();
  std::size_t in_quadratic = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector3d expected = points[i];
    const QuadraticTie& tie = drawn.quadratic[i];
    for (std::size_t a = 0; a < 4; ++a) expected += tie.weights[a] * state.displacement[drawn.ties[i].vertices[a]];
    for (std::size_t m = 0; m < 6 && tie.middles != kNoMidEdges; ++m)
      expected += tie.weights[4 + m] * state.displacement[tie.middles[m]];
    in_quadratic += tie.middles != kNoMidEdges;
    const shared::vec4& p = positions[model.rest_positions.size() + i];
    CAPTURE(i, expected.transpose(), p.x, p.y, p.z);
    CHECK((Vector3d(p.x, p.y, p.z) - expected).norm() < 1e-7);
  }
  CHECK(in_quadratic == (mixed ? 1 : 4));
}

TEST_CASE("the GPU refuses methods that have no kernels for quadratic tets", "[gpu]") {
  Gpu gpu;
  const Model model = quadratic_bar(MaterialModel::st_venant_kirchhoff);
  SolverSettings settings = settings_with(5);
  settings.method = Method::vertex_descent;
  settings.acceleration = Acceleration::none;
  CHECK_THROWS_WITH(
      GpuSolver(gpu.programs, model, settings),
      "solver.method: vertex_descent does not carry quadratic elements; expected two_level, or bodies with "
      "linear elements");
}
