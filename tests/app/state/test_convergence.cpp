// The residual within a substep, for the current settings and for pinned ones: the order of measurements, their
// results, and the absence of side effects.
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/state/convergence.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

SolverSettings with(Method method, Acceleration acceleration, int iterations = 10) {
  SolverSettings settings;
  settings.method = method;
  settings.acceleration = acceleration;
  settings.iterations = iterations;
  return settings;
}

const SolverSettings kJacobi = with(Method::jacobi, Acceleration::none, 3),
                     kDescent = with(Method::vertex_descent, Acceleration::none);

Scene cube() {  // of a law that Jacobi carries
  return open_scene(source_dir() / "assets/scenes/cube.json", {"materials.default.model=signed_st_venant_kirchhoff"});
}

}  // namespace

TEST_CASE("lines of the convergence plot take turns, and measure the next step without side effects", "[convergence]") {
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(cube(), graphics.programs.get(), false), alone(cube(), graphics.programs.get(), false);
  Convergence convergence;
  CHECK(convergence.lines().empty());
  CHECK_FALSE(convergence.can_pin(kJacobi));  // nothing is measured yet
  convergence.measure(simulation, *graphics.programs);
  convergence.pin(kJacobi);
  convergence.pin(kDescent);
  CHECK_FALSE(convergence.can_pin(kJacobi));
  std::vector<std::size_t> measured;
  for (int i = 0; i < 4; ++i) {
    const auto before = convergence.lines();
    convergence.measure(simulation, *graphics.programs);
    const auto after = convergence.lines();
    for (std::size_t k = 0; k < after.size(); ++k)
      if (after[k].residuals != before[k].residuals) measured.push_back(k);
    simulation.step();
    alone.step();
  }
  CHECK(measured == std::vector<std::size_t>{1, 2, 0, 1});
  CHECK(simulation.state().displacement == alone.state().displacement);

  const auto lines = convergence.lines();
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].name == "two_level + subspace");
  CHECK(lines[1].name == "jacobi");
  CHECK(lines[2].name == "vertex_descent");
  for (const Convergence::Line& line : lines) {
    CAPTURE(line.name, line.residuals);
    CHECK_FALSE(line.diverged);
    CHECK(line.residuals.size() ==
          static_cast<std::size_t>(simulation.scene.solver.iterations) + 1);  // also for pinned ones
    CHECK(line.residuals.back() < line.residuals.front());
  }
  CHECK(lines[0].residuals.back() < 0.1f * lines[1].residuals.back());
}

TEST_CASE("pins are limited, can be removed, and are kept when the scene changes", "[convergence]") {
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(cube(), graphics.programs.get(), false);
  Convergence convergence;
  convergence.measure(simulation, *graphics.programs);
  SolverSettings settings = with(Method::jacobi, Acceleration::anderson_positions);
  for (int window = 1; window <= 9; ++window) {
    settings.window = window;
    convergence.pin(settings);
  }
  CHECK(convergence.lines().size() == Convergence::kMostLines);
  CHECK(convergence.lines()[1].name == "jacobi + anderson_positions, window 1");
  convergence.unpin(0);  // that of the current settings
  convergence.unpin(Convergence::kMostLines);
  CHECK(convergence.lines().size() == Convergence::kMostLines);
  convergence.unpin(1);
  CHECK(convergence.lines()[1].name == "jacobi + anderson_positions, window 2");
  CHECK_FALSE(convergence.lines()[0].residuals.empty());
  convergence.forget();
  CHECK(convergence.lines().size() == Convergence::kMostLines - 1);
  for (const Convergence::Line& line : convergence.lines()) CHECK(line.residuals.empty());
}

TEST_CASE("a line ends where its residual is not finite, and the reference solver has none", "[convergence]") {
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(cube(), graphics.programs.get(), false), exact(cube(), graphics.programs.get(), true);
  Convergence convergence;
  convergence.measure(exact, *graphics.programs);
  CHECK(convergence.lines().empty());
  State lost = simulation.state();
  const std::vector<char> held = simulation.model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) lost.displacement[v] = {1e25, -1e25, 1e25};
  simulation.gpu()->upload(lost);
  convergence.measure(simulation, *graphics.programs);
  REQUIRE(convergence.lines().size() == 1);
  CHECK(convergence.lines()[0].diverged);
}
