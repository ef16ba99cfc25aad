#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/fit/parameter.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using test::BlockScene;

Parameter parameter_of(const BlockScene& block, const std::string& key) {
  return parameters_of(block.scene(), {key}).front();
}

TEST_CASE("parameters begin at the scene's values, in the scale that fits them", "[fit]") {
  const BlockScene block;
  const Parameter young = parameter_of(block, "materials.default.young_modulus");
  CHECK(young.start == 20000);
  CHECK(young.logarithmic);
  CHECK(!young.bounds);
  const Parameter poisson = parameter_of(block, "materials.default.poisson_ratio");
  CHECK(!poisson.logarithmic);
  REQUIRE(poisson.bounds);
  CHECK(poisson.bounds->high == 0.499);
  CHECK(parameter_of(block, "bodies[0].materials.stiff.young_modulus").start == 60000);
  CHECK(parameter_of(block, "materials.stiff.density").start == 1000);  // of the default material
  CHECK(parameter_of(block, "prescribed.0.translate.0").start == 0.02);
  CHECK(!parameter_of(block, "gravity.1").logarithmic);
}

TEST_CASE("coordinates of a parameter lead back to its value and have their rates", "[fit]") {
  Parameter p;
  p.start = 300;
  p.prior = {400, 40};
  Parameter bounded = p, ratio;
  bounded.bounds = {100, 1000};
  ratio.logarithmic = false;
  ratio.bounds = {-0.9, 0.499};
  ratio.prior = {0.3, 0.05};
  for (const auto& [parameter, value] : {std::pair(p, 300.0), std::pair(bounded, 300.0), std::pair(ratio, 0.45)}) {
    const double x = parameter.inner(value), h = 1e-5;
    CHECK(parameter.value(x) == Approx(value).epsilon(1e-12));
    const double up = parameter.natural(parameter.value(x + h)), down = parameter.natural(parameter.value(x - h));
    CHECK(parameter.natural_rate(x) == Approx((up - down) / (2 * h)).epsilon(1e-8));
    CHECK(parameter.prior_rate(x) ==
          Approx((parameter.prior_distance(x + h) - parameter.prior_distance(x - h)) / (2 * h)).epsilon(1e-8));
    CHECK(parameter.prior_distance(parameter.inner(parameter.prior->mean)) == Approx(0).margin(1e-12));
  }
  CHECK(bounded.value(50) <= 1000);
  CHECK(bounded.value(-50) >= 100);
  CHECK(std::isfinite(bounded.inner(100)));  // a start at a bound
}

TEST_CASE("wrong keys, bounds and priors are one line", "[fit]") {
  const BlockScene block;
  const auto wrong = [&](const std::string& key) { parameters_of(block.scene(), {key}); };
  CHECK_THROWS_WITH(wrong("materials.default.young_modulos"),
                    Catch::StartsWith("--free materials.default.young_modulos: unknown key \"young_modulos\", perhaps "
                                      "\"young_modulus\""));
  CHECK_THROWS_WITH(wrong("colour.x"), Catch::StartsWith("--free colour.x: unknown key \"colour\""));
  CHECK_THROWS_WITH(wrong("materials.default.model"),
                    "--free materials.default.model: is no number of the scene; expected one such as "
                    "materials.default.young_modulus");
  CHECK_THROWS_WITH(wrong("ground.friction"), Catch::StartsWith("--free ground.friction"));
  CHECK_THROWS_WITH(wrong(""), "--free : has no key; expected a number of the scene, as for --set");
  CHECK_THROWS_WITH(parameters_of(block.scene(), {"gravity.1", "gravity.1"}),
                    "--free gravity.1: is given twice; expected every key once");

  std::vector<Parameter> parameters =
      parameters_of(block.scene(), {"materials.default.young_modulus", "materials.default.poisson_ratio"});
  const auto bounds = [&](const std::string& text) { set_bounds(parameters, text); };
  CHECK_THROWS_WITH(bounds("materials.default.young_module=1:2"),
                    Catch::Contains("names no free parameter, perhaps \"materials.default.young_modulus\""));
  CHECK_THROWS_WITH(bounds("materials.default.young_modulus=1e4"),
                    Catch::Contains("is not KEY=LOW:HIGH; expected two numbers"));
  CHECK_THROWS_WITH(bounds("materials.default.young_modulus=3e4:1e4"), Catch::Contains("is an empty range"));
  CHECK_THROWS_WITH(bounds("materials.default.young_modulus=3e4:4e4"),
                    Catch::Contains("excludes the scene's value 2e+04"));
  CHECK_THROWS_WITH(bounds("materials.default.poisson_ratio=0:0.6"), Catch::Contains("leaves the range of scenes"));
  bounds("materials.default.young_modulus=1e4:4e4");
  CHECK(parameters[0].bounds->high == 4e4);
  CHECK_THROWS_WITH(set_prior(parameters, "materials.default.young_modulus=0:1"),
                    Catch::Contains("is no distribution of a positive number"));
  set_prior(parameters, "materials.default.young_modulus=1.5e4:3e3");
  CHECK(parameters[0].prior->spread == 3e3);
}

}  // namespace
}  // namespace fascia
