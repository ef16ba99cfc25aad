// Rates of equilibria by implicit differentiation against differences of solved equilibria.
// Covers: force_balance
#include <catch2/catch.hpp>

#include "sim/reference/tangent/static_tangent.h"
#include "tests/sim/reference/tangent/tangent_bar.h"

namespace fascia::reference {
namespace {

using test::bar_model;
using test::bar_springs;
using test::BarParameters;

State equilibrium(const Model& model, double stiffness) {
  State state = initial_state(model);
  NewtonSolver solver(model, {});
  solver.set_springs(bar_springs(stiffness));
  const NewtonReport report = solver.solve_static(state, 1e-14);
  REQUIRE(report.converged);
  return state;
}

TEST_CASE("the rate of an equilibrium is that of solved equilibria", "[tangent]") {
  const MaterialModel law = GENERATE(MaterialModel::st_venant_kirchhoff, MaterialModel::stable_neo_hookean,
                                     MaterialModel::mooney_rivlin, MaterialModel::squared);
  double BarParameters::*const field =
      GENERATE(&BarParameters::young, &BarParameters::poisson, &BarParameters::density, &BarParameters::gravity,
               &BarParameters::stretch, &BarParameters::stiffness);
  const BarParameters middle;
  const double value = middle.*field;
  const Model model = bar_model(middle, law);
  const std::vector<GrabSpring> springs = bar_springs(middle.stiffness);
  StaticTangent tangent(model);
  REQUIRE(tangent.linearize(equilibrium(model, middle.stiffness), {model, springs}));
  constexpr double kStep = 1e-4;
  const BarParameters down = moved(middle, field, -kStep), up = moved(middle, field, kStep);
  const Model below = bar_model(down, law), above = bar_model(up, law);
  const auto rate =
      tangent.rate({below, bar_springs(down.stiffness)}, {above, bar_springs(up.stiffness)}, kStep * value);

  const auto solved = [&](double share) {
    const BarParameters p = moved(middle, field, share);
    return test::flat(equilibrium(bar_model(p, law), p.stiffness).displacement);
  };
  const Eigen::VectorXd difference = test::difference_quotient(solved, value, 1e-3);
  const double error = (test::flat(rate) - difference).norm() / difference.norm();
  CAPTURE(name_of(law), value, difference.norm(), error);
  CHECK(error < 1e-6);
}

TEST_CASE("an equilibrium that is not stable has no tangent", "[tangent]") {
  const Model model = test::box_model(2, 2, 2, {0.1, 0.1, 0.1}, test::soft(1e4));
  StaticTangent tangent(model);
  CHECK(!tangent.linearize(initial_state(model), {model, {}}));  // free: the Hessian has six zero eigenvalues
}

}  // namespace
}  // namespace fascia::reference
