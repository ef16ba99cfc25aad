// Advice beside fields: cases with advice and cases without.
#include "app/session/advice.h"

#include <catch2/catch.hpp>
#include <limits>

#include "sim/mesh/mesh_generate.h"

using namespace fascia;

namespace {

std::optional<UnitHint> unit_hint_of(double size, double scale = 1) {
  Scene scene;
  scene.bodies.emplace_back().transform.scale = scale;
  Model model;
  const TetMesh mesh = make_box(1, 1, 1, {size, 0.1 * size, 0.1 * size});
  model.rest_positions = mesh.positions;
  model.rest_positions.push_back({1e9, 0, 0});  // in no tet
  model.tets = mesh.tets;
  return unit_hint(scene, model);
}

std::optional<Hint> residual_hint(double residual, SolverChoice choice = solver_choices().front()) {
  SolverSettings settings;
  settings.method = choice.method;
  settings.acceleration = choice.acceleration;
  Diagnostics diagnostics;
  diagnostics.residual = residual;
  return iterations_hint(settings, diagnostics);
}

}  // namespace

TEST_CASE("a Poisson's ratio at which linear tets lock gets advice") {
  CHECK_FALSE(locking_hint(0.3, true));
  CHECK_FALSE(locking_hint(kLockingPoissonRatio, true));
  REQUIRE(locking_hint(0.451, true));
  CHECK(locking_hint(0.451, true)->name == "locking");
  CHECK(locking_hint(0.451, true)->remedy == "Quadratic elements");
  CHECK(locking_hint(0.451, false)->remedy.empty());
}

TEST_CASE("a body of implausible size gets advice with the unit that makes it plausible") {
  CHECK_FALSE(unit_hint_of(0.2));
  CHECK_FALSE(unit_hint_of(3));
  CHECK_FALSE(unit_hint_of(1e12));  // no unit fits
  const std::optional<UnitHint> millimeters = unit_hint_of(120);
  REQUIRE(millimeters);
  CHECK(millimeters->scale == 1e-3);
  CHECK(millimeters->hint.text == "120 m wide: made in millimeters?");
  CHECK(millimeters->hint.remedy == "Scale to 120 mm");
  CHECK(unit_hint_of(1e5)->scale == 1e-6);
  CHECK(unit_hint_of(1e-4)->scale == 1e3);
  // The advice refers to the current scale of the body.
  CHECK_THAT(unit_hint_of(120, 10)->hint.help, Catch::Contains("transform.scale=0.01 "));
  CHECK_FALSE(unit_hint(Scene{}, Model{}));
}

TEST_CASE("a residual of a tenth gets advice, and other methods get the advice of two_level") {
  CHECK_FALSE(iterations_hint(SolverSettings{}, std::nullopt));
  CHECK_FALSE(residual_hint(0.099));
  CHECK_FALSE(residual_hint(std::numeric_limits<double>::quiet_NaN()));
  REQUIRE(residual_hint(0.1));
  CHECK(residual_hint(0.234)->text == "Residual 0.23: too few iterations?");
  CHECK_THAT(residual_hint(0.5)->help, Catch::Contains("More iterations, shorter steps"));
  CHECK(residual_hint(0.5)->remedy.empty());
  CHECK(residual_hint(0.5, {Method::gauss_seidel, Acceleration::none})->remedy == "Use Two-level");
  // Averaged Jacobi stays soft however many iterations it gets.
  const std::optional<Hint> jacobi = residual_hint(0.5, {Method::jacobi, Acceleration::none});
  CHECK(jacobi->text == "Residual 0.5: this method stays too soft.");
  CHECK(jacobi->remedy == "Use Two-level");
}

TEST_CASE("substeps that are long for the motion of the tissue get advice") {
  SolverSettings settings;
  CHECK_FALSE(time_step_hint(settings));
  settings.time_step = 0.05;
  CHECK(time_step_hint(settings));
  settings.integrator = Integrator::bdf2;  // keeps motion
  CHECK_FALSE(time_step_hint(settings));
  settings.integrator = Integrator::implicit_euler;
  settings.substeps = 2;
  CHECK_FALSE(time_step_hint(settings));
}
