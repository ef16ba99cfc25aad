#include <catch2/catch.hpp>

#include "sim/reference/newton.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using test::BlockScene;
using Kind = Measurand::Kind;

TEST_CASE("equilibria are those at the times of the measurement, and at the end", "[fit]") {
  const BlockScene block;
  const Scene scene = block.scene();
  const Model model = build_model(scene);
  const std::vector<Measurement> measured{
      {"a.csv", 1, {test::curve_of("support_1_x", {Kind::support, 1, 0}, {0.5, 0.25})}, {}, {}},
      {"b.csv", 4, {test::curve_of("reaction_y", {Kind::reaction, 0, 1}, {})}, {}, {}}};
  const Experiment experiment(measured, true, 0, test::kReference);
  const auto response = experiment.run(scene, model);
  REQUIRE(response);
  REQUIRE(response->values.size() == 3);

  // A scene that ends at that time is the same equilibrium.
  const auto force_at = [&](double stretch) {
    Model ended = model;
    ended.motions[0].translate = {stretch, 0, 0};
    State state = initial_state(ended);
    REQUIRE(reference::NewtonSolver(ended, scene.solver).solve_static(state).converged);
    return reference::support_forces(ended, state)[1].force.x();
  };
  CHECK(response->values[0] == Approx(force_at(0.01)).epsilon(1e-8));
  CHECK(response->values[1] == Approx(force_at(0.005)).epsilon(1e-8));
  double mass = 0;
  for (const double m : lumped_masses(model)) mass += m;
  CHECK(response->values[2] == Approx(9.81 * mass).epsilon(1e-9));
  CHECK(experiment.residuals(response->values)[2] == Approx(2 * response->values[2]));  // the root of the weight
}

TEST_CASE("in motion, values between two steps are interpolated", "[fit]") {
  const BlockScene block(
      R"("young_modulus": 20000, "poisson_ratio": 0.4)",
      R"("solver": {"time_step": 0.02}, "grabs": [{"at": [0.06, 0.04, 0.02], "translate": [0, 0.01, 0]}], )");
  const Scene scene = block.scene();
  const Model model = build_model(scene);
  const std::vector<Measurement> measured{{"a.csv",
                                           1,
                                           {test::curve_of("vertex_30_y", {Kind::vertex, 30, 1}, {0, 0.02, 0.05, 0.1}),
                                            test::curve_of("grab_y", {Kind::grab, 0, 1}, {0.1})},
                                           {},
                                           {}}};
  const auto response = Experiment(measured, false, 0, test::kReference).run(scene, model);
  REQUIRE(response);
  State state = initial_state(model);
  reference::NewtonSolver solver(model, scene.solver);
  std::vector<double> heights{0};
  std::vector<GrabSpring> springs;
  for (int step = 1; step <= 5; ++step) {
    springs = with_grabs({}, model.grabs, state.time + 0.02);
    solver.set_springs(springs);
    solver.step(state);
    heights.push_back(state.displacement[30].y());
  }
  CHECK(response->values[0] == 0);
  CHECK(response->values[1] == Approx(heights[1]).epsilon(1e-12));
  CHECK(response->values[2] == Approx(0.5 * (heights[2] + heights[3])).epsilon(1e-9));
  CHECK(response->values[3] == Approx(heights[5]).epsilon(1e-9));
  CHECK(response->values[4] == Approx(forces_of_grabs(springs, state.displacement).at(0).force.y()).epsilon(1e-9));
}

}  // namespace
}  // namespace fascia
