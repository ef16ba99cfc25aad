#include "app/refine/trial_run.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::filesystem::path kCube = source_dir() / "assets/scenes/cube.json";

}  // namespace

TEST_CASE("trials measure every kind of elements with both integrators", "[refine]") {
  Gpu gpu;
  int lines = 0;
  const std::vector<Trial> trials =
      run_trials(open_scene(kCube), gpu.programs, 10, [&](const std::string&) { ++lines; });
  REQUIRE(trials.size() == 4);
  CHECK(lines == 4);
  for (const Trial& trial : trials) {
    CAPTURE(name_of(trial.elements), name_of(trial.integrator), trial.mesh, trial.time, trial.solver_few, trial.ms_few);
    CHECK(trial.mesh > 0);
    CHECK(trial.mesh < 1);
    CHECK(trial.time > 0);
    CHECK(trial.solver_many <= trial.solver_few);
    CHECK(trial.ms_few > 0);
    CHECK(trial.ms_many > 0);
  }
  CHECK(trials[2].mesh < trials[0].mesh);  // quadratic, linear

  const std::vector<Trial> linear =
      run_trials(open_scene(kCube, {"solver.method=vertex_descent"}), gpu.programs, 2, [](const std::string&) {});
  CHECK(linear.size() == 2);
}
