// Rates of motions by implicit differentiation against differences of simulated motions.
#include <catch2/catch.hpp>

#include "sim/integrators/integrator.h"
#include "sim/reference/tangent/step_tangent.h"
#include "tests/sim/reference/tangent/tangent_bar.h"

namespace fascia::reference {
namespace {

using test::bar_model;
using test::bar_springs;
using test::BarParameters;

constexpr int kSteps = 6;
constexpr double kStep = 0.02;  // [s]

// Calls visit(stage, state before, state after) for every stage of the motion.
template <class Visit>
State motion(const Model& model, Integrator integrator, double stiffness, const Visit& visit) {
  State state = initial_state(model);
  NewtonSolver solver(model, {});
  solver.set_springs(bar_springs(stiffness));
  for (int step = 0; step < kSteps; ++step) {
    for (const IntegratorStage& stage : stages_of(integrator, kStep, state.earlier.step)) {
      const State before = state;
      REQUIRE(solver.solve(stage, state).converged);
      visit(stage, before, state);
    }
    state.earlier.step = kStep;
    if (!info_of(integrator).multistep) state.earlier = {};
  }
  return state;
}

TEST_CASE("the rate of a motion is that of simulated motions", "[tangent]") {
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  const MaterialModel law = MaterialModel::stable_neo_hookean;
  double BarParameters::*const field =
      GENERATE(&BarParameters::young, &BarParameters::poisson, &BarParameters::density, &BarParameters::damping,
               &BarParameters::gravity, &BarParameters::stretch, &BarParameters::stiffness);
  const BarParameters middle;
  const double value = middle.*field;
  constexpr double kShare = 1e-4;
  const BarParameters down = moved(middle, field, -kShare), up = moved(middle, field, kShare);
  const Model model = bar_model(middle, law), below = bar_model(down, law), above = bar_model(up, law);
  const std::vector<GrabSpring> here = bar_springs(middle.stiffness), fewer = bar_springs(down.stiffness),
                                more = bar_springs(up.stiffness);
  StepTangent tangent(model);
  StateRate rate = tangent.at_rest();
  motion(model, integrator, middle.stiffness,
         [&](const IntegratorStage& stage, const State& before, const State& after) {
           REQUIRE(tangent.linearize(stage, before, after.displacement, {model, here}));
           rate = tangent.rate(rate, {below, fewer}, {above, more}, kShare * value);
         });

  const auto simulated = [&](double share) {
    const BarParameters p = moved(middle, field, share);
    const State end = motion(bar_model(p, law), integrator, p.stiffness, [](auto&&...) {});
    Eigen::VectorXd both(6 * end.velocity.size());
    both << test::flat(end.displacement), kStep * test::flat(end.velocity);
    return both;
  };
  Eigen::VectorXd both(2 * rate.displacement.size());
  both << rate.displacement, kStep * rate.velocity;
  const Eigen::VectorXd difference = test::difference_quotient(simulated, value, 1e-3);
  const double error = (both - difference).norm() / difference.norm();
  CAPTURE(name_of(integrator), value, difference.norm(), error);
  CHECK(error < 1e-6);
}

}  // namespace
}  // namespace fascia::reference
