// Exact rates are tested in tests/sim/fit/simulated/test_moved_moments.cpp.
#include <catch2/catch.hpp>

#include "sim/fit/misfit.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using Eigen::VectorXd;
using test::BlockScene;
using Kind = Measurand::Kind;

TEST_CASE("parameters of the mesh have differences, one simulation each", "[fit]") {
  const BlockScene block;
  const Scene scene = block.scene({"solver.time_step=0.05"});
  const std::vector<Measurement> measured{
      {"a.csv", 1, {test::curve_of("support_1_x", {Kind::support, 1, 0}, {0.5, 1})}, {}, {}}};
  const TunedScene tuned(scene, build_model(scene),
                         parameters_of(scene, {"transform.scale", "materials.default.density"}));
  const Experiment experiment(measured, GENERATE(false, true), 0, test::kReference);
  const Misfit misfit(tuned, experiment);
  const std::vector<double> start = tuned.start();
  VectorXd x = Eigen::Map<const VectorXd>(start.data(), 2);
  const auto point = misfit.at(x);
  CHECK(!misfit.exact(*point));
  const Eigen::MatrixXd rates = misfit.rates(*point);
  CHECK(misfit.simulations() == 2);
  x[0] += 1e-2;
  const VectorXd up = misfit.at(x)->residuals;
  x[0] -= 2e-2;
  const VectorXd central = (up - misfit.at(x)->residuals) / 2e-2;
  CHECK((rates.col(0) - central).norm() < 5e-3 * central.norm());  // half the step of the one-sided difference
}

TEST_CASE("values that scenes refuse have no residuals", "[fit]") {
  const BlockScene block;
  const Scene scene = block.scene();
  const std::vector<Measurement> measured{
      {"a.csv", 1, {test::curve_of("support_1_x", {Kind::support, 1, 0}, {1})}, {}, {}}};
  const TunedScene tuned(scene, build_model(scene), parameters_of(scene, {"materials.default.young_modulus"}));
  const Experiment experiment(measured, true, 0, test::kReference);
  const Misfit misfit(tuned, experiment);
  CHECK(misfit.at(VectorXd::Constant(1, std::log(20000))));
  CHECK(!misfit.at(VectorXd::Constant(1, 80)));  // 5e34 Pa
}

}  // namespace
}  // namespace fascia
