#include <algorithm>

#include "tests/api/api_scenes.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

TEST_CASE("Tissues have values that a scene accepts, and unknown names are refused with the known ones") {
  const std::vector<std::string> names = tissues();
  REQUIRE(std::find(names.begin(), names.end(), "liver") != names.end());
  const Material liver = tissue("liver");
  CHECK(liver.density > 900);
  CHECK(liver.young_modulus < 1e5);
  Body body = standing_cube();
  body.material = liver;
  CHECK(Simulation(scene_of(body), context()).material(0) == liver);
  CHECK_THAT(error_of([] { tissue("steel"); }), Contains("steel") && Contains("liver"));
}

TEST_CASE("Materials out of range are refused with field, value and range") {
  Body body = standing_cube();
  body.material.young_modulus = -5;
  CHECK_THAT(error_of([&] { Simulation(scene_of(body), context()); }),
             Contains("bodies[0].material.young_modulus: is -5; expected 0.001 to 1e+14 Pa"));
  body.material.young_modulus = std::nan("");
  CHECK_THAT(error_of([&] { Simulation(scene_of(body), context()); }), Contains("young_modulus"));
  body.material = {.model = "rubber"};
  CHECK_THAT(error_of([&] { Simulation(scene_of(body), context()); }),
             Contains("rubber") && Contains("st_venant_kirchhoff"));
}

TEST_CASE("Every listed law can be simulated by the default method") {
  for (const std::string& model : material_models()) {
    CAPTURE(model);
    Body body = standing_cube();
    body.material.model = model;
    Simulation simulation(scene_of(body), context());
    simulation.step(2);
    CHECK(simulation.diagnostics().elastic > 0);
  }
}

TEST_CASE("The law-specific number of a material comes back unchanged") {
  Body body = standing_cube();
  body.material.model = "mooney_rivlin";
  body.material.mooney_ratio = 0.6;
  CHECK(Simulation(scene_of(body), context()).material(0) == body.material);
  body.material.mooney_ratio = 1.5;
  CHECK_THAT(error_of([&] { Simulation(scene_of(body), context()); }),
             Contains("mooney_ratio: is 1.5; expected 0 to 1"));
}

TEST_CASE("A material that changes during the simulation acts on the next equilibrium") {
  Simulation simulation(scene_of(standing_cube()), context());
  simulation.set_gravity({0, -0.981, 0});  // strains of 0.3 percent, at which the law is linear except for that amount
  REQUIRE(simulation.solve_static().converged);
  const double soft = simulation.diagnostics().volume_ratio;
  Material stiff = simulation.material(0);
  stiff.young_modulus *= 10;
  simulation.set_material(0, stiff);
  CHECK(simulation.material(0) == stiff);
  REQUIRE(simulation.solve_static().converged);
  CHECK(1 - simulation.diagnostics().volume_ratio == Approx((1 - soft) / 10).epsilon(0.02));
  CHECK_THAT(error_of([&] { simulation.set_material(1, stiff); }), Contains("material 1"));
  CHECK_THAT(error_of([&] { simulation.set_material(0, {.density = 0}); }), Contains("density"));
  CHECK(simulation.material(0) == stiff);
}
