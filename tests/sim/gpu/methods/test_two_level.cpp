// The passes of the two-level method against the same iteration in double precision, on large rotations, where errors
// of float32 and of frozen rotations are largest.
// Covers: coarse_level, sim/gpu/passes/step_gradient
#include <catch2/catch.hpp>

#include "sim/gpu/methods/two_level.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/double_two_level.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using Eigen::VectorXd;
using shared::vec4;

namespace {

constexpr MaterialModel kPlain = MaterialModel::st_venant_kirchhoff,
                        kSigned = MaterialModel::signed_st_venant_kirchhoff,
                        kStable = MaterialModel::stable_neo_hookean, kNeo = MaterialModel::neo_hookean,
                        kMooney = MaterialModel::mooney_rivlin, kSquaredLaw = MaterialModel::squared;

// A strongly bent beam of two materials, with additional random strains.
Model beam(MaterialModel soft = kPlain, MaterialModel stiff = kPlain) {
  Model model = make_model(make_box(16, 4, 4, {0.4, 0.1, 0.1}), {1e5, 0.35, 1000, 0, soft},
                           [](const Vector3d& x) { return x.x() < 1e-9; });
  model.materials.push_back({2e6, 0.3, 1200, 0, stiff});
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    if (model.rest_positions[model.tets[t][0]].x() > 0.25) model.tet_material[t] = 1;
  return model;
}

State bent(const Model& model) {
  State state = random_state(model, 5e-4, 7);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    const Vector3d& x = model.rest_positions[v];
    const double angle = 4 * x.x(), radius = 0.25 - x.y();
    if (x.x() > 1e-9)
      state.displacement[v] += Vector3d(radius * std::sin(angle), 0.25 - radius * std::cos(angle), x.z()) - x;
  }
  return state;
}

VectorXd flat(const gl::Buffer& buffer, std::uint32_t count) {
  VectorXd all(3 * static_cast<Eigen::Index>(count));
  const std::vector<vec4> values = buffer.read<vec4>();
  for (std::uint32_t v = 0; v < count; ++v)
    all.segment<3>(3 * static_cast<Eigen::Index>(v)) << values[v].x, values[v].y, values[v].z;
  return all;
}

void run(const Passes& passes) {
  for (const gl::ComputePass& pass : passes) pass.run();
}

// The data that a step has before its first iteration.
struct FirstIteration {
  explicit FirstIteration(gl::LoadPath loads, Acceleration acceleration, MaterialModel soft = kPlain,
                          MaterialModel stiff = kPlain, double noise = 0)
      : gpu(loads), model(beam(soft, stiff)) {
    settings.acceleration = acceleration;
    buffers.upload_step(model, settings, IntegratorStage{settings.substep()});
    State state = bent(model);
    const State more = random_state(model, noise, 9);
    for (std::size_t v = 0; v < state.displacement.size(); ++v) state.displacement[v] += more.displacement[v];
    buffers.upload_state(model, state);
    prediction(gpu.programs, buffers, nullptr, {false}).run();
  }
  Gpu gpu;
  Model model;
  SolverSettings settings;
  SimBuffers buffers{model};
  Features features = features_of(model);
  gl::Buffer no_strain;
  EnergyTerms terms;
  Recording recording{gpu.programs, buffers, features, no_strain, terms};
  DeferredTets deferred{{1, buffers.pair_and_single_count()}};
  VectorXd displacement() const { return flat(buffers.displacement, buffers.vertex_count); }
};

}  // namespace

TEST_CASE("the gradient of a step and its objective", "[gpu]") {
  const auto [soft, stiff] = GENERATE(
      std::pair(kPlain, kPlain), std::pair(kSigned, kSigned), std::pair(kStable, kStable), std::pair(kSigned, kStable),
      std::pair(kPlain, kSigned), std::pair(kNeo, kNeo), std::pair(kMooney, kMooney), std::pair(kNeo, kStable),
      std::pair(kMooney, kPlain), std::pair(kSquaredLaw, kSquaredLaw), std::pair(kSquaredLaw, kSigned));
  const double noise = GENERATE(0.0, 0.03);  // [m] the larger one inverts tets
  CAPTURE(name_of(soft), name_of(stiff), noise);
  FirstIteration s(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage), Acceleration::none, soft, stiff, noise);
  if (s.features.models.contains(MaterialModel::signed_st_venant_kirchhoff))
    s.recording.deferred = GENERATE(false, true) ? &s.deferred : nullptr;
  const VectorXd start = s.displacement();
  const DoubleTwoLevel exact(s.model, s.settings.substep(), start, flat(s.buffers.predicted, s.buffers.vertex_count));
  const StepGradient gradient(s.gpu.programs, s.buffers);
  run(gradient.passes(s.recording));
  double objective = 0, sum = 0;
  const VectorXd expected = exact.gradient(start, objective);
  for (const vec4& g : gradient.gradient().read<vec4>()) sum += g.w;
  const double error = (flat(gradient.gradient(), s.buffers.vertex_count) - expected).norm() / expected.norm();
  CAPTURE(error, sum, objective);
  CHECK(error < 2e-5);
  CHECK(sum == Approx(objective).epsilon(1e-5));
}

TEST_CASE("steps within the span of the corrections and the last step", "[gpu]") {
  const Acceleration acceleration = GENERATE(Acceleration::none, Acceleration::nonlinear_cg, Acceleration::subspace);
  const MaterialModel soft = GENERATE(kPlain, kStable, kNeo, kMooney, kSquaredLaw);
  FirstIteration s(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage), acceleration, soft);
  const VectorXd start = s.displacement();
  DoubleTwoLevel exact(s.model, s.settings.substep(), start, flat(s.buffers.predicted, s.buffers.vertex_count));
  TwoLevelMethod method(s.gpu.programs, s.model, s.buffers, s.settings);
  method.complete();
  exact.begin(flat(s.buffers.previous_displacement, s.buffers.vertex_count));
  run(method.begin(s.recording));
  CHECK((s.displacement() - start).norm() <= 1e-6 * start.norm());  // back at the start
  run(method.refresh(s.recording));
  for (const int iteration : {0, 1, 2}) {
    run(method.before(s.recording, iteration == 0));
    run(method.iteration(s.recording, iteration == 0));
    run(method.complete_iteration(s.recording));
    exact.descend(acceleration);
    const double error = (s.displacement() - exact.displacement()).norm() / (exact.displacement() - start).norm();
    CAPTURE(name_of(acceleration), name_of(soft), iteration, error);
    CHECK(error < 3e-5);
  }
}

TEST_CASE("deferred tets take part in a step like the others", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const MaterialModel stiff = GENERATE(kSigned, kPlain);
  FirstIteration at_once(loads, Acceleration::subspace, kSigned, stiff, 0.03),
      later(loads, Acceleration::subspace, kSigned, stiff, 0.03);
  const VectorXd start = at_once.displacement();
  const auto iterate = [](FirstIteration& s, DeferredTets* deferred) {
    TwoLevelMethod method(s.gpu.programs, s.model, s.buffers, s.settings);
    method.complete();
    Recording blocks = s.recording;  // its blocks are exact in both
    s.recording.deferred = deferred;
    method.prepare(s.recording);
    run(method.begin(s.recording));
    run(method.refresh(blocks));
    for (const bool first : {true, false}) {
      run(method.before(s.recording, first));
      run(method.iteration(s.recording, first));
    }
    run(method.complete_iteration(s.recording));
  };
  iterate(at_once, nullptr);
  iterate(later, &later.deferred);
  const std::uint32_t deferred = later.deferred.count();
  const double difference =
      (later.displacement() - at_once.displacement()).norm() / (at_once.displacement() - start).norm();
  CAPTURE(gl::name_of(loads), name_of(stiff), deferred, difference);
  CHECK(deferred > later.buffers.pair_and_single_count() / 10);
  CHECK(deferred < later.buffers.pair_and_single_count());
  CHECK(difference < 1e-4);
}

TEST_CASE("Anderson's direction beside the correction: the same first step, then a lower objective", "[gpu]") {
  FirstIteration s(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage), Acceleration::anderson);
  const VectorXd start = s.displacement();
  DoubleTwoLevel exact(s.model, s.settings.substep(), start, flat(s.buffers.predicted, s.buffers.vertex_count));
  TwoLevelMethod method(s.gpu.programs, s.model, s.buffers, s.settings);
  method.complete();
  exact.begin(flat(s.buffers.previous_displacement, s.buffers.vertex_count));
  run(method.begin(s.recording));
  run(method.refresh(s.recording));
  for (int iteration = 0; iteration < 20; ++iteration) {
    run(method.before(s.recording, iteration == 0));
    run(method.iteration(s.recording, iteration == 0));
    run(method.complete_iteration(s.recording));
    exact.descend(Acceleration::none);
    const double error = (s.displacement() - exact.displacement()).norm() / (exact.displacement() - start).norm();
    CAPTURE(error);
    if (iteration == 0) CHECK(error < 1e-4);
  }
  double plain = 0, accelerated = 0;
  exact.gradient(exact.displacement(), plain);
  exact.gradient(s.displacement(), accelerated);
  CHECK(accelerated < plain);
}

TEST_CASE("a change of acceleration keeps the levels", "[gpu]") {
  Gpu gpu;
  const Model model = beam();
  SolverSettings settings;
  GpuSolver switched(gpu.programs, model, settings);
  switched.step();
  settings.acceleration = Acceleration::nonlinear_cg;
  switched.set_settings(settings);
  const State start = bent(model);
  switched.upload(start);
  switched.step();
  GpuSolver fresh(gpu.programs, model, settings);
  fresh.upload(start);
  fresh.step();
  CHECK(relative_rms(switched.download().displacement, fresh.download().displacement) == 0);
  CHECK(switched.dispatches_per_step() == fresh.dispatches_per_step());
}
