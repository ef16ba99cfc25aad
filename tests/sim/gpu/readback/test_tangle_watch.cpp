// The law squared is eased while tissue may be tangled, and is itself again once it is upright or under a load.
#include "sim/gpu/readback/tangle_watch.h"

#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/material/invariants.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model one_tet() {
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.regions = {0};
  return make_model(mesh, {2e4, 0.3, 1000, 0, MaterialModel::squared}, [](const Vector3d& x) { return x.z() < 1e-9; });
}

State of_volume(const Model& model, double ratio) {
  State state = initial_state(model);
  state.displacement[3] = float32_of(Vector3d(0, 0, 0.1 * (ratio - 1)));
  return state;
}

}  // namespace

TEST_CASE("the law is eased from an inverted tet until all are upright again") {
  Easing easing;
  easing.look(0.1, 0, false);
  CHECK_FALSE(easing.eased());
  easing.look(0, 0.1, false);
  CHECK(easing.eased());
  easing.look(0.2, 0.2, false);
  CHECK(easing.eased());
  easing.look(0.31, 0.3, false);
  CHECK_FALSE(easing.eased());
  easing.look(-1, 0.4, false);
  CHECK(easing.eased());
}

TEST_CASE("tets that stay inverted without a hand have the law itself, until they are handled or upright") {
  for (const bool by_hand : {true, false}) {
    Easing easing;
    easing.look(-1, 1, true);
    easing.look(-1, 9, true);
    CHECK(easing.eased());
    easing.look(-1, 10.9, false);
    CHECK(easing.eased());
    easing.look(-1, 11, false);
    CHECK_FALSE(easing.eased());
    easing.look(-1, 12, false);
    CHECK_FALSE(easing.eased());
    if (!by_hand) easing.look(0.4, 13, false);
    easing.look(-1, 14, by_hand);
    CHECK(easing.eased());
  }
}

TEST_CASE("the watch finds an inverted tet a reading later, and forgets it with a new state", "[gpu]") {
  Gpu gpu;
  const Model model = one_tet();
  SimBuffers buffers(model);
  TangleWatch watch(gpu.programs, buffers);
  const auto first_eased = [&](double ratio) {
    buffers.upload_state(model, of_volume(model, ratio));
    watch.restart();
    int step = 0;
    while (step < 40 && !watch.is_eased(0, true)) ++step;
    return step;
  };
  CHECK(first_eased(0.1) == 40);
  CHECK(first_eased(-0.1) == TangleWatch::kInterval);
  CHECK(first_eased(1.5) == 40);
}

TEST_CASE("a solver eases the law of a tet that is pushed through its foot, and ends that with a new state", "[gpu]") {
  Gpu gpu;
  const Model model = one_tet();
  GpuSolver solver(gpu.programs, model, {});
  const auto pushed_to = [&](double ratio) {
    solver.set_grab({{3, Vector3d(0, 0, 0.1 * (ratio - 1)), 1e6}});
    for (int step = 0; step < 3 * TangleWatch::kInterval; ++step) solver.step();
    return solver.buffers().eased;
  };
  CHECK_FALSE(pushed_to(0.5));
  CHECK(pushed_to(-0.5));
  CHECK(pushed_to(0.2));
  CHECK_FALSE(pushed_to(0.5));
  CHECK(pushed_to(-0.5));
  solver.reset();
  CHECK_FALSE(solver.buffers().eased);
}

// A tet that is drawn down to J stretches by J along z. Both the energy and the hand's force tell the law.
TEST_CASE("an eased tet has the energy and the force of the law with the larger share", "[gpu]") {
  Gpu gpu;
  Model model = one_tet();
  model.gravity.setZero();
  const double mu = model.materials[0].lame_mu(), k = model.materials[0].lame_lambda() - 2 * mu / 3;
  const auto density = [&](double j, double least) {
    const double i1 = 2 + j * j;
    return mu / 12 * (i1 * i1 - 9) + mu * (above_extended_log(j - 1, least).value - (j - 1)) +
           k / 2 * (j - 1) * (j - 1);
  };
  constexpr double kVolume = 0.001 / 6, kSide = 0.1, kGrip = 1e6, kNudge = 1e-5;
  for (const bool eased : {false, true}) {
    const double least = eased ? kLeastVolumeRatio : kLeastVolumeRatioOfSquared;
    GpuSolver solver(gpu.programs, model, {});
    const auto pull_to = [&](double ratio) {
      solver.set_grab({{3, Vector3d(0, 0, kSide * (ratio - 1)), kGrip}});
      for (int step = 0; step < 8 * TangleWatch::kInterval; ++step) solver.step();
    };
    if (eased) pull_to(-0.5);
    pull_to(0.1);
    REQUIRE(solver.buffers().eased == eased);
    const double z = solver.download().displacement[3].z(), j = 1 + z / kSide;
    const double force = kGrip * (kSide * (0.1 - 1) - z);  // of the hand [N]
    const double exact = kVolume / kSide * (density(j + kNudge, least) - density(j - kNudge, least)) / (2 * kNudge);
    solver.request_diagnostics();
    const double energy = solver.take_diagnostics(true)->elastic;
    CAPTURE(eased, j, force, exact, energy, kVolume * density(j, least), kVolume * density(j, 0.25 - least));
    CHECK(j < kLeastVolumeRatio);
    CHECK(force == Approx(exact).epsilon(2e-4));
    CHECK(energy == Approx(kVolume * density(j, least)).epsilon(1e-5));
    CHECK(energy != Approx(kVolume * density(j, 0.25 - least)).epsilon(1e-3));  // of the other share
  }
}

TEST_CASE("the kernels learn that the law is eased from the fraction of its number", "[gpu]") {
  Gpu gpu;
  const Model model = one_tet();
  SimBuffers buffers(model);
  const IntegratorStage stage{1.0 / 60};
  for (const bool eased : {false, true}) {
    buffers.eased = eased;
    buffers.upload_step(model, {}, stage);
    const float number = buffers.step.read<shared::StepValues>().front().material.w;
    CHECK(number == static_cast<float>(MaterialModel::squared) + (eased ? 0.5f : 0));
  }
}
