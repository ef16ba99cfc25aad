// The table of material constants and the derived constants.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/material/material.h"

using namespace fascia;

TEST_CASE("every default is in its range and every constant has a help text") {
  Material material;
  int count = 0;
  visit_material(material, [&](double& field, const char* name, const char*, double min, double max, bool logarithmic,
                               const char* help) {
    CAPTURE(name);
    CHECK(field >= min);
    CHECK(field <= max);
    if (logarithmic) CHECK(min > 0);
    CHECK(std::string(help).size() > 10);
    ++count;
  });
  CHECK(count == 5);
}

TEST_CASE("Lame's constants give back Young's modulus, Poisson's ratio and the bulk modulus") {
  Material material;
  material.young_modulus = 2.5e5;
  for (const double nu : {-0.9, -0.3, 0.0, 0.3, 0.45, 0.499}) {
    CAPTURE(nu);
    material.poisson_ratio = nu;
    const double lambda = material.lame_lambda(), mu = material.lame_mu();
    // Near 0.5 and -1 the inverse formulas divide by small differences: 1e-12 is 1e-16 over the smallest, 0.002 * 0.1.
    CHECK(mu * (3 * lambda + 2 * mu) / (lambda + mu) == Approx(2.5e5).epsilon(1e-12));
    CHECK(lambda / (2 * (lambda + mu)) == Approx(nu).epsilon(1e-12).margin(1e-15));
    CHECK(lambda + 2 * mu / 3 == Approx(2.5e5 / (3 * (1 - 2 * nu))).epsilon(1e-12));
  }
  material.poisson_ratio = 0.3;  // as in the verification cases
  CHECK(material.lame_lambda() == Approx(144230.76923076922).epsilon(1e-15));
  CHECK(material.lame_mu() == Approx(96153.84615384616).epsilon(1e-15));
}

TEST_CASE("material models are found by their names") {
  REQUIRE(!material_models().empty());
  for (const MaterialModel model : material_models()) CHECK(find_material_model(name_of(model)) == model);
  CHECK(std::string(name_of(MaterialModel::st_venant_kirchhoff)) == "st_venant_kirchhoff");
  CHECK(!find_material_model("rubber"));
}
