// Which steps are compared with the exact ones, and the worst of them.
#include "sim/simulation/errors/worst_step.h"

#include <catch2/catch.hpp>

#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the worst step is relative to the largest displacement of those compared", "[true_error]") {
  WorstStep worst(500, 10);
  CHECK(worst.of_displacement() == 0);
  StepError error;
  error.rms = 2e-3;
  error.displacement = 1e-2;
  worst.add(error, 0.1);
  error.rms = 1e-4;
  error.displacement = 0.1;
  worst.add(error, 0.2);
  CHECK(worst.of_displacement() == Approx(0.02));
  CHECK(worst.time() == 0.1);
  CHECK(worst.compared() == 2);
}

TEST_CASE("all steps of short runs are compared, of long ones those with larger residuals", "[true_error]") {
  Gpu gpu;
  constexpr long kSteps = 10;
  const auto compared = [&](long steps) {
    Simulation simulation(open_scene(cube_path(), {"solver.iterations=2"}), &gpu.programs, false);
    simulation.gpu()->solve_everything();
    WorstStep worst(simulation.model.tets.size(), steps);
    for (long i = 0; i < kSteps; ++i) {
      simulation.step();
      worst.look(simulation);
    }
    CHECK(worst.of_displacement() > 0);
    return worst.compared();
  };
  CHECK(compared(kSteps) == kSteps);
  const int few = compared(1'000'000'000);
  CHECK(few >= 1);
  CHECK(few < kSteps);
}
