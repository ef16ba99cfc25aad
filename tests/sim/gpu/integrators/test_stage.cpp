// The passes of a stage, alone, against double precision on random states. Tolerances: one or a few float32
// operations per output, 6e-8 each.
#include <catch2/catch.hpp>

#include "sim/gpu/integrators/stage.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/gpu/unpack.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using shared::vec4;

TEST_CASE("predict adds velocity and gravity to free vertices only", "[gpu]") {
  const bool split = GENERATE(false, true);
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const Model model = block();
  SimBuffers buffers(model);
  SolverSettings settings;
  settings.time_step = 1.0 / 90;
  const double h = settings.substep();
  buffers.upload_step(model, settings, IntegratorStage{h});
  const State state = random_state(model, 0.01, 1);
  buffers.upload_state(model, state);
  prediction(gpu.programs, buffers, split ? &buffers.tet_begin : nullptr).run();
  const std::vector<char> held = model.held();
  const std::vector<double> mass = lumped_masses(model);
  std::vector<Vector3d> expected = state.displacement;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!held[i]) expected[i] += h * (state.velocity[i] + h * model.gravity);
  CHECK(relative_rms(unpack(buffers.displacement), expected) < 3e-7);
  CHECK(relative_rms(unpack(buffers.predicted), expected) < 3e-7);
  CHECK(relative_rms(unpack(buffers.previous_displacement), state.displacement) == 0);
  const std::vector<vec4> values = buffers.displacement.read<vec4>(), predicted = buffers.predicted.read<vec4>();
  std::vector<int> valence(values.size(), 0);
  for (const Tet& tet : model.tets)
    for (const auto v : tet) ++valence[v];
  for (std::size_t i = 0; i < values.size(); ++i) {
    CAPTURE(i);
    CHECK(predicted[i].w == Approx(held[i] ? 0 : 1 / mass[i]).epsilon(1e-6));
    CHECK(values[i].w == Approx(held[i] ? 0 : (split ? valence[i] : 1) / mass[i]).epsilon(1e-6));
  }
}

TEST_CASE("velocity is the change of displacement over the substep", "[gpu]") {
  Gpu gpu;
  const Model model = block();
  SimBuffers buffers(model);
  const SolverSettings settings;
  const double h = settings.substep();
  buffers.upload_step(model, settings, IntegratorStage{h});
  const State now = random_state(model, 0.01, 1), before = random_state(model, 0.01, 2);
  buffers.upload_state(model, before);
  const std::vector<vec4> previous = buffers.displacement.read<vec4>();
  buffers.previous_displacement.upload(0, buffers.previous_displacement.bytes(), previous.data());
  buffers.upload_state(model, now);
  const Features features = features_of(model);
  const gl::Buffer no_strain;
  velocity_update({gpu.programs, buffers, features, no_strain, {}}).run();
  std::vector<Vector3d> expected;
  for (std::size_t i = 0; i < now.displacement.size(); ++i)
    expected.push_back((now.displacement[i] - before.displacement[i]) / h);
  CHECK(relative_rms(unpack(buffers.velocity), expected) < 3e-7);
}
