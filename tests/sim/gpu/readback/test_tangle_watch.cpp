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

constexpr double kVolume = 0.001 / 6, kSide = 0.1;

// Of the law squared, in a tet that stretches by j along z; `least`: from where its logarithm is continued.
double density(const Material& m, double j, double least) {
  const double mu = m.lame_mu(), k = m.lame_lambda() - 2 * mu / 3, i1 = 2 + j * j;
  return mu / 12 * (i1 * i1 - 9) + mu * (above_extended_log(j - 1, least).value - (j - 1)) + k / 2 * (j - 1) * (j - 1);
}

// That holds the upper vertex there [N].
double force_at(const Material& m, double j, double least) {
  constexpr double kNudge = 1e-5;
  return kVolume / kSide * (density(m, j + kNudge, least) - density(m, j - kNudge, least)) / (2 * kNudge);
}

}  // namespace

TEST_CASE("the law is eased from an inverted tet until all are upright again") {
  Easing easing;
  easing.look(0.1, 0, false);
  CHECK(easing.hardness() == Hardness::own);
  easing.look(0, 0.1, false);
  CHECK(easing.hardness() == Hardness::eased);
  easing.look(0.2, 0.2, false);
  CHECK(easing.hardness() == Hardness::eased);
  easing.look(0.31, 0.3, false);
  CHECK(easing.hardness() == Hardness::own);
  easing.look(-1, 0.4, false);
  CHECK(easing.hardness() == Hardness::eased);
}

TEST_CASE("tets that stay inverted without a hand make the law firm, until they are handled or upright") {
  for (const bool by_hand : {true, false}) {
    Easing easing;
    easing.look(-1, 1, true);
    easing.look(-1, 9, true);
    CHECK(easing.hardness() == Hardness::eased);
    easing.look(-1, 10.9, false);
    CHECK(easing.hardness() == Hardness::eased);
    easing.look(-1, 11, false);
    CHECK(easing.hardness() == Hardness::own);
    easing.look(-1, 12, false);
    CHECK(easing.hardness() == Hardness::firm);
    easing.look(0.1, 12.5, false);
    CHECK(easing.hardness() == Hardness::firm);
    if (!by_hand) {
      easing.look(0.4, 13, false);
      CHECK(easing.hardness() == Hardness::own);
    }
    easing.look(-1, 14, by_hand);
    CHECK(easing.hardness() == Hardness::eased);
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
    while (step < 40 && watch.hardness(0, true) == Hardness::own) ++step;
    return step;
  };
  CHECK(first_eased(0.1) == 40);
  CHECK(first_eased(-0.1) == TangleWatch::kInterval);
  CHECK(first_eased(1.5) == 40);
}

// The corners of the tet stay where they are: a mid-edge vertex that moves by d along its edge of 0.1 m leads to J = 1
// + 40 d at a corner, and to J = 1 + 17.9 d at the point next to it.
TEST_CASE(
    "the watch looks at the points of a quadratic tet, where the law acts, and at linear tets beside it, while other "
    "tets rest",
    "[gpu]") {
  Gpu gpu;
  TetMesh mesh;
  for (const double x : {0.0, 1.0})
    mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 0.1, 0, 0}, {x, 0.1, 0}, {x, 0, 0.1}});
  mesh.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  mesh.regions = {0, 0};
  const Material tissue{2e4, 0.3, 1000, 0, MaterialModel::squared};
  const auto nothing_held = [](const Vector3d&) { return false; };
  const std::uint32_t first = GENERATE(0u, 1u);  // quadratic tet: all of them, or beside a linear one
  const Model model = quadratic(make_model(mesh, tissue, nothing_held), first);
  SimBuffers buffers(model);
  TangleWatch watch(gpu.programs, buffers);
  const auto eases = [&](std::uint32_t vertex, double along_z) {
    State state = initial_state(model);
    state.displacement[vertex] = float32_of(Vector3d(0, 0, along_z));
    buffers.upload_state(model, state);
    watch.restart();
    for (int step = 0; step < 2 * TangleWatch::kInterval; ++step)
      if (watch.hardness(0, true) == Hardness::eased) return true;
    return false;
  };
  const std::uint32_t middle = model.mid_edges[1][3];  // of the edge along z
  CHECK_FALSE(eases(middle, 0));
  CHECK_FALSE(eases(middle, -0.04));
  CHECK(eases(middle, -0.07));
  if (first == 1) CHECK(eases(3, -0.11));
}

TEST_CASE("a solver eases the law of a tet that is pushed through its foot, and ends that with a new state", "[gpu]") {
  Gpu gpu;
  const Model model = one_tet();
  GpuSolver solver(gpu.programs, model, {});
  const auto pushed_to = [&](double ratio) {
    solver.set_grab({{3, Vector3d(0, 0, 0.1 * (ratio - 1)), 1e6}});
    for (int step = 0; step < 3 * TangleWatch::kInterval; ++step) solver.step();
    return solver.buffers().hardness == Hardness::eased;
  };
  CHECK_FALSE(pushed_to(0.5));
  CHECK(pushed_to(-0.5));
  CHECK(pushed_to(0.2));
  CHECK_FALSE(pushed_to(0.5));
  CHECK(pushed_to(-0.5));
  solver.reset();
  CHECK(solver.buffers().hardness == Hardness::own);
}

// A tet that is drawn down to J stretches by J along z. Both the energy and the hand's force tell the law.
TEST_CASE("an eased tet has the energy and the force of the law with the larger share", "[gpu]") {
  Gpu gpu;
  Model model = one_tet();
  model.gravity.setZero();
  constexpr double kGrip = 1e6;
  const Material material = model.materials[0];
  for (const bool eased : {false, true}) {
    const double least = eased ? kLeastVolumeRatio : kLeastVolumeRatioOfSquared;
    GpuSolver solver(gpu.programs, model, {});
    const auto pull_to = [&](double ratio) {
      solver.set_grab({{3, Vector3d(0, 0, kSide * (ratio - 1)), kGrip}});
      for (int step = 0; step < 8 * TangleWatch::kInterval; ++step) solver.step();
    };
    if (eased) pull_to(-0.5);
    pull_to(0.1);
    REQUIRE(solver.buffers().hardness == (eased ? Hardness::eased : Hardness::own));
    const double z = solver.download().displacement[3].z(), j = 1 + z / kSide;
    const double force = kGrip * (kSide * (0.1 - 1) - z);  // of the hand [N]
    const double exact = force_at(material, j, least);
    solver.request_diagnostics();
    const double energy = solver.take_diagnostics(true)->elastic;
    CAPTURE(eased, j, force, exact, energy, kVolume * density(material, j, least),
            kVolume * density(material, j, 0.25 - least));
    CHECK(j < kLeastVolumeRatio);
    CHECK(force == Approx(exact).epsilon(2e-4));
    CHECK(energy == Approx(kVolume * density(material, j, least)).epsilon(1e-5));
    CHECK(energy != Approx(kVolume * density(material, j, 0.25 - least)).epsilon(1e-3));  // of the other share
  }
}

// Twice the load that the law itself carries upright.
TEST_CASE("a tet that its weight keeps inverted turns upright once the law is firm", "[gpu]") {
  Gpu gpu;
  Model model = one_tet();
  const Material material = model.materials[0];
  const double load = -2 * force_at(material, 0, kLeastVolumeRatioOfSquared);
  model.gravity = {0, 0, -load / (kVolume * material.density / 4)};
  GpuSolver solver(gpu.programs, model, {});
  const auto ratio_after = [&](int steps) {
    for (int step = 0; step < steps; ++step) solver.step();
    return 1 + solver.download().displacement[3].z() / kSide;
  };
  const double eased = ratio_after(60);
  CHECK(solver.buffers().hardness == Hardness::eased);
  const double firm = ratio_after(120);
  CHECK(solver.buffers().hardness == Hardness::firm);
  CAPTURE(load, eased, firm);
  CHECK(eased < 0);
  CHECK(firm > 0);
  CHECK(-force_at(material, firm, kLeastVolumeRatioOfFirm) == Approx(load).epsilon(1e-3));
}

TEST_CASE("the kernels learn that the law is eased or firm from the fraction of its number", "[gpu]") {
  Gpu gpu;
  const Model model = one_tet();
  SimBuffers buffers(model);
  const IntegratorStage stage{1.0 / 60};
  for (const auto& [hardness, fraction] :
       {std::pair{Hardness::own, 0.0f}, {Hardness::eased, 0.5f}, {Hardness::firm, 0.25f}}) {
    buffers.hardness = hardness;
    buffers.upload_step(model, {}, stage);
    const float number = buffers.step.read<shared::StepValues>().front().material.w;
    CHECK(number == static_cast<float>(MaterialModel::squared) + fraction);
  }
}
