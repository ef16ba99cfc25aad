// The XPBD methods against their double-precision transcription: one tet pass, one vertex pass, whole steps.
//
// Tolerances: float32 carries 6e-8 relative. The strain of a state with displacement gradients of 0.1 to 0.3 is known
// to about 1e-7 relative; the 6x6 system's condition number (about 1 / (1 - 2 nu), times the spread of the tet's shape,
// some tens) amplifies that to a few 1e-6. A whole step has such errors in 20 iterations, which damp them.
// Covers: exact_xpbd, gauss_seidel, jacobi, methods, sim/reference/double_acceleration, sim/reference/double_xpbd
#include <catch2/catch.hpp>

#include "sim/gpu/methods/jacobi.h"
#include "sim/gpu/solver.h"
#include "sim/ordering/morton_order.h"
#include "sim/reference/double_xpbd.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using reference::DoubleXpbd;
using reference::Vector6d;
using shared::vec4;

namespace {

Model beam(const Material& material) {
  return make_model(make_box(6, 3, 2, {0.2, 0.1, 0.07}), material, [](const Vector3d& x) { return x.x() < 1e-9; });
}

// For every tet, the slots in which its pair stores the values for each vertex.
std::vector<std::map<std::uint32_t, std::uint32_t>> slots_of_corners(const SimBuffers& buffers) {
  const auto tets = buffers.tet_vertices.read<Tet>();
  const auto slots = buffers.pair_slots.read<Tet>();
  const auto fifth = buffers.pair_fifth.read<Tet>();
  std::vector<std::map<std::uint32_t, std::uint32_t>> result(tets.size());
  for (std::uint32_t i = 0; i < buffers.pair_and_single_count(); ++i) {
    for (int a = 0; a < 4; ++a) result[i][tets[i][a]] = slots[i][a];
    if (i >= buffers.pair_count) continue;
    const std::uint32_t second = buffers.pair_and_single_count() + i;
    result[i][tets[second][3]] = fifth[i][1];
    result[second] = result[i];
  }
  return result;
}

}  // namespace

TEST_CASE("tet corrections and multipliers equal the double-precision block solve", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const double nu = GENERATE(-0.9, 0.0, 0.3, 0.45, 0.499);
  const double damping = GENERATE(0.0, 0.02);
  const double young = GENERATE(1e3, 1e9);
  CAPTURE(gl::name_of(loads), nu, damping, young);
  Gpu gpu(loads);
  // Random displacements that leave tets upright, and some that invert many of them.
  const auto [material_model, amplitude] = GENERATE(std::pair(MaterialModel::st_venant_kirchhoff, 0.004),
                                                    std::pair(MaterialModel::signed_st_venant_kirchhoff, 0.03));
  CAPTURE(name_of(material_model));
  Model model = beam({young, nu, 1000, damping, material_model});
  SolverSettings settings;
  const bool split = GENERATE(false, true);
  settings.method = split ? Method::mass_splitting : Method::jacobi;
  SimBuffers buffers(model);
  buffers.upload_step(model, settings, IntegratorStage{settings.substep()});
  const State state = random_state(model, amplitude, 3);
  buffers.upload_state(model, state);
  const Features features = features_of(model);
  gl::Buffer previous_strain("previous_strain", bytes_of_previous_strain(gpu.programs, buffers));
  const JacobiMethod method(buffers, split);
  const EnergyTerms no_terms{};
  // predict stores the inverse masses with the displacements and moves the vertices; the comparison starts from its
  // result.
  prediction(gpu.programs, buffers, split ? &buffers.tet_begin : nullptr).run();
  if (features.damping)
    gl::ComputePass(
        gpu.programs.compute("sim/step/previous_strain.comp"),
        with_pairs({{"previous_displacement", &buffers.previous_displacement}, {"previous_strain", &previous_strain}},
                   buffers),
        buffers.pair_and_single_count(), constants_of_pairs(buffers))
        .run();
  const State moved = buffers.download_state(0);

  DeferredTets deferred({1, buffers.pair_and_single_count()});
  const bool defers = features.models.contains(MaterialModel::signed_st_venant_kirchhoff) && GENERATE(false, true);
  CAPTURE(defers);
  const Recording recording{gpu.programs, buffers, features, previous_strain, no_terms, defers ? &deferred : nullptr};
  const auto first = method.iteration(recording, true);
  const auto next = method.iteration(recording, false);
  const DoubleXpbd exact(model, settings);
  const std::vector<std::map<std::uint32_t, std::uint32_t>> slots = slots_of_corners(buffers);
  const std::vector<std::uint32_t> order = paired_tets(model).order;
  const auto compare = [&](const std::vector<Vector6d>& lambda, const std::vector<Vector3d>& u) {
    const std::vector<vec4> correction = buffers.correction.read<vec4>();
    std::vector<Vector3d> got, expected(correction.size(), Vector3d::Zero());
    for (const vec4& c : correction) got.emplace_back(c.x, c.y, c.z);
    std::vector<Vector6d> updated;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::uint32_t t = order[k];
      const auto r = exact.solve_tet(t, u, exact.strain(t, state.displacement), lambda[k]);
      updated.push_back(r.multiplier);
      for (int a = 0; a < 4; ++a) expected[slots[k].at(model.tets[t][a])] += r.correction[a];
    }
    // 1 - 2 nu = 0.002 at nu = 0.499 costs three digits of the compliance matrix itself.
    const double tolerance = 3e-6 + 4e-8 / (1 - 2 * nu);
    const double error = relative_rms(got, expected);
    CAPTURE(error, tolerance);
    CHECK(error < tolerance);
    return updated;
  };
  const std::size_t tet_passes = defers ? 2 : 1;
  for (std::size_t i = 0; i < tet_passes; ++i) first[i].run();
  const auto lambda = compare(std::vector<Vector6d>(model.tets.size(), Vector6d::Zero()), moved.displacement);

  // The second iteration must start from the multipliers that the first one stored.
  first[tet_passes].run();
  const State averaged = buffers.download_state(0);
  for (std::size_t i = 0; i < tet_passes; ++i) next[i].run();
  compare(lambda, averaged.displacement);
}

namespace {

Model twisted_beam(double damping) {
  Model model = beam({3e4, 0.4, 900, damping, MaterialModel::st_venant_kirchhoff});
  // A second material, so that the comparison includes the per-tet lookup.
  model.materials.push_back({2e5, 0.2, 1500, 0, MaterialModel::st_venant_kirchhoff});
  for (std::size_t t = 0; t < model.tets.size(); t += 3) model.tet_material[t] = 1;
  Motion motion;
  for (std::uint32_t i = 0; i < model.rest_positions.size(); ++i)
    if (model.rest_positions[i].x() > 0.2 - 1e-9) motion.vertices.push_back(i);
  motion.axis = Vector3d::UnitX();
  motion.angle = 0.5;
  motion.center = {0, 0.05, 0.035};
  motion.duration = 0.1;
  model.motions.push_back(motion);
  return model;
}

}  // namespace

TEST_CASE("whole steps equal the double-precision method", "[gpu]") {
  const Method method = GENERATE(Method::jacobi, Method::mass_splitting, Method::gauss_seidel);
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const double damping = GENERATE(0.0, 0.01);
  SolverSettings settings;
  settings.method = method;
  settings.acceleration = Acceleration::none;
  settings.substeps = GENERATE(1, 4);
  if (method == Method::gauss_seidel) settings.colors = GENERATE(0, 1, 6, 40);
  CAPTURE(name_of(method), settings.colors, gl::name_of(loads), damping, settings.substeps);
  Gpu gpu(loads);
  const Model model = twisted_beam(damping);

  GpuSolver solver(gpu.programs, model, settings);
  DoubleXpbd exact(model, settings);
  State state = random_state(model, 0.001, 8);
  solver.upload(state);
  for (int step = 0; step < 10; ++step) {
    solver.step();
    exact.step(state);
  }
  const State got = solver.download();
  CHECK(got.time == Approx(state.time));
  const double error = relative_rms(got.displacement, state.displacement);
  const double velocity_error = relative_rms(got.velocity, state.velocity);
  CAPTURE(error, velocity_error);
  CHECK(error < 1e-5);
  CHECK(velocity_error < 1e-4);  // v = (u - u_n) / h loses the digits that u and u_n share
}

TEST_CASE("accelerated steps equal the double-precision method", "[gpu]") {
  const SolverChoice pair = GENERATE(from_range(i3d2019_choices()));
  if (pair.acceleration == Acceleration::none) return;
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.iterations = 12;
  settings.window = 3;
  if (pair.acceleration == Acceleration::chebyshev) settings.spectral_radius = GENERATE(0.0, 0.8);
  CAPTURE(name_of(pair.method), name_of(pair.acceleration), gl::name_of(loads), settings.spectral_radius);
  Gpu gpu(loads);
  const Model model = twisted_beam(0);
  GpuSolver solver(gpu.programs, model, settings);
  DoubleXpbd exact(model, settings);
  State state = random_state(model, 0.001, 8);
  solver.upload(state);
  for (int step = 0; step < 3; ++step) {
    solver.step();
    exact.step(state);
  }
  const double error = relative_rms(solver.download().displacement, state.displacement);
  SolverSettings plain = settings;
  plain.acceleration = Acceleration::none;
  DoubleXpbd unaccelerated(model, plain);
  State plain_state = random_state(model, 0.001, 8);
  for (int step = 0; step < 3; ++step) unaccelerated.step(plain_state);
  const double effect = relative_rms(plain_state.displacement, state.displacement);
  CAPTURE(error, effect);
  // Extrapolation amplifies rounding: weights solve a system of condition up to 1e6 (regularization), so they lose
  // digits, but only in directions that hardly change the result.
  CHECK(error < 1e-4);
  CHECK(effect > 30 * error);  // the acceleration has an effect, and this comparison detects it
}
