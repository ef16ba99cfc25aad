// Experiments on the GPU against the same ones of the reference solver.
#include "sim/fit/gpu/gpu_simulator.h"

#include <catch2/catch.hpp>

#include "tests/sim/fit/block_scene.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

namespace fascia {
namespace {

using test::BlockScene;
using Kind = Measurand::Kind;

constexpr const char* kDragged = R"("grabs": [{"at": [0.06, 0.04, 0.02], "translate": [0, 0.01, 0], "start": 0}], )";

std::vector<Measurement> pulled() {
  return {{"a.csv",
           1,
           {test::curve_of("support_1_x", {Kind::support, 1, 0}, {0.25, 0.5}),
            test::curve_of("grab_y", {Kind::grab, 0, 1}, {0.25, 0.5}),
            test::curve_of("vertex_30_y", {Kind::vertex, 30, 1}, {0.25, 0.5})},
           {},
           {}}};
}

TEST_CASE("an experiment on the GPU observes what the reference does", "[fit][gpu]") {
  const BlockScene block(R"("young_modulus": 20000, "poisson_ratio": 0.4)", kDragged);
  const Scene scene = block.scene();
  const Model model = build_model(scene);
  test::Gpu gpu;
  const GpuSimulator simulator(gpu.programs);
  const bool is_static = GENERATE(true, false);
  const auto here = Experiment(pulled(), is_static, 0, simulator).run(scene, model);
  const auto expected = Experiment(pulled(), is_static, 0, test::kReference).run(scene, model);
  REQUIRE(here);
  REQUIRE(expected);
  CHECK_FALSE(here->differentiable);
  CHECK(here->moments.size() == expected->moments.size());
  for (Eigen::Index i = 0; i < expected->values.size(); ++i) {
    CAPTURE(is_static, i, here->values[i], expected->values[i]);
    CHECK(here->values[i] == Approx(expected->values[i]).epsilon(is_static ? 1e-7 : 1e-5));
  }
}

TEST_CASE("an equilibrium on the GPU goes on from the one before", "[fit][gpu]") {
  const BlockScene block(R"("young_modulus": 20000, "poisson_ratio": 0.4)", kDragged);
  const Scene scene = block.scene({"solver.tolerance=1e-4"});  // without Newton's last iterations
  const Model model = build_model(scene);
  test::Gpu gpu;
  const GpuSimulator simulator(gpu.programs);
  const Schedule once{true, {0.5}, true, 0}, twice{true, {0.25, 0.5}, true, 0};
  const auto direct = simulator.run(scene, model, once), by_way = simulator.run(scene, model, twice);
  REQUIRE(direct);
  REQUIRE(by_way);
  REQUIRE(by_way->moments.size() == 3);
  CHECK(by_way->moments[1].state.time == 0.5);
  for (const std::size_t k : {0u, 1u}) {
    const double size = test::largest_displacement(direct->moments[k].state);
    const double apart = test::farthest(direct->moments[k].state, by_way->moments[k + 1].state);
    CAPTURE(k, size, apart);
    CHECK(apart < 2e-4 * size);
  }
}

TEST_CASE("a fit on the GPU finds the values of the reference", "[fit][gpu]") {
  const BlockScene block("\"young_modulus\": 20000, \"poisson_ratio\": 0.4");
  std::vector<Measurement> measured{{"a.csv",
                                     1,
                                     {test::curve_of("support_1_x", {Kind::support, 1, 0}, test::moments(4, 0.2)),
                                      test::curve_of("vertex_30_y", {Kind::vertex, 30, 1}, test::moments(4, 0.2))},
                                     {},
                                     {}}};
  test::measure(measured, block.scene(), false, 0, 1);
  for (MeasuredCurve& curve : measured[0].curves) curve.noise = 0.01 * std::abs(curve.values.back());
  const Scene start = block.scene({"materials.default.young_modulus=15000", "materials.default.poisson_ratio=0.3"});
  const TunedScene tuned(start, build_model(start),
                         parameters_of(start, {"materials.default.young_modulus", "materials.default.poisson_ratio"}));
  test::Gpu gpu;
  const GpuSimulator simulator(gpu.programs);
  const FitResult result = fit(tuned, Experiment(measured, false, start.duration, simulator), {});
  REQUIRE(result.converged);
  CHECK_FALSE(result.exact_rates);
  const auto& found = result.estimates.parameters;
  CAPTURE(found[0].value, found[1].value, result.simulations);
  CHECK(found[0].value == Approx(20000).epsilon(1e-4));
  CHECK(found[1].value == Approx(0.4).epsilon(1e-4));
  CHECK(result.simulations <= 20);
}

}  // namespace
}  // namespace fascia
