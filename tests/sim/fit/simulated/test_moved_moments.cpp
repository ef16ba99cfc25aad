// Rates of residuals by implicit differentiation against differences of simulations.
// Covers: simulator, reference_simulator
#include <catch2/catch.hpp>

#include "sim/fit/misfit.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using Eigen::VectorXd;
using test::BlockScene;
using Kind = Measurand::Kind;

TEST_CASE("rates of residuals are those of simulations", "[fit]") {
  const bool is_static = GENERATE(true, false);
  const char* const integrator = GENERATE("implicit_euler", "bdf2", "sdirk2");
  const std::string elements = GENERATE("linear", "quadratic");
  if (is_static && integrator != std::string("bdf2")) return;
  if (elements == "quadratic" && (is_static || integrator != std::string("sdirk2"))) return;
  const BlockScene block("\"young_modulus\": 20000, \"poisson_ratio\": 0.45, \"damping\": 0.01",
                         R"("grabs": [{"at": [0.06, 0.04, 0.02], "translate": [0, 0.01, 0], "stiffness": 20}], )");
  const Scene scene = block.scene({std::string("solver.integrator=") + integrator, "solver.time_step=0.05",
                                   "solver.substeps=2", "grabs.0.start=0", "bodies.0.elements=" + elements});
  const Model model = build_model(scene);
  std::vector<Measurement> measured{{"a.csv", 1, {}, {}, {}}, {"b.obj", 2, {}, {}, {}}};
  measured[0].curves = {test::curve_of("support_1_x", {Kind::support, 1, 0}, {0.52, 1}),
                        test::curve_of("grab_y", {Kind::grab, 0, 1}, {1}),
                        test::curve_of("reaction_y", {Kind::reaction, 0, 1}, {1}),
                        test::curve_of("vertex_30_y", {Kind::vertex, 30, 1}, {0.5, 1})};
  for (MeasuredCurve& curve : measured[0].curves) curve.noise = curve.dimension == Dimension::force ? 1e-2 : 1e-4;
  measured[1].shapes = {{{}, {{0.06, 0.05, 0.021}, {0.071, -0.01, 0.017}, {0.03, 0.02, 0.05}}, 1e-4}};
  const std::vector<std::string> keys{"materials.default.young_modulus", "materials.default.poisson_ratio",
                                      "materials.stiff.young_modulus",   "materials.default.density",
                                      "prescribed.0.translate.0",        "grabs.0.stiffness"};
  std::vector<Parameter> parameters = parameters_of(scene, keys);
  set_prior(parameters, "materials.default.density=1100:50");
  const TunedScene tuned(scene, model, parameters);
  const Experiment experiment(measured, is_static, 1, test::kReference);
  const Misfit misfit(tuned, experiment);
  const std::vector<double> start = tuned.start();
  const VectorXd x = Eigen::Map<const VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
  const auto point = misfit.at(x);
  REQUIRE(point);
  CHECK(misfit.exact(*point));
  const Eigen::MatrixXd rates = misfit.rates(*point);
  CHECK(misfit.simulations() == 1);
  for (Eigen::Index p = 0; p < x.size(); ++p) {
    const auto residuals_at = [&](double away) {
      VectorXd moved = x;
      moved[p] += away;
      return misfit.at(moved)->residuals;
    };
    constexpr double kStep = 2e-3;
    const VectorXd difference =
        (8 * (residuals_at(kStep) - residuals_at(-kStep)) - (residuals_at(2 * kStep) - residuals_at(-2 * kStep))) /
        (12 * kStep);
    const double error = (rates.col(p) - difference).norm() / difference.norm();
    CAPTURE(is_static, integrator, elements, keys[static_cast<std::size_t>(p)], error, rates.col(p).transpose(),
            difference.transpose());
    CHECK(error < 1e-6);
  }
}

}  // namespace
}  // namespace fascia
