#include "app/refine/trial_run.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/grab/build_model.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::filesystem::path kCube = source_dir() / "assets/scenes/cube.json";

struct CubeRuns {
  explicit CubeRuns(std::vector<std::string> sets = {}, long steps = 10) : sets_(std::move(sets)), steps_(steps) {}
  TrialRuns operator()() {
    const auto open = [this](const std::vector<std::string>& more) {
      std::vector<std::string> all = sets_;
      all.insert(all.end(), more.begin(), more.end());
      Scene scene = open_scene(kCube, all);
      Model model = build_model(scene);
      return OpenedScene{std::move(scene), std::move(model)};
    };
    return {scene_, open, gpu_.programs, steps_, [this](const std::string&) { ++lines; }};
  }
  int lines = 0;

 private:
  std::vector<std::string> sets_;
  long steps_;
  Scene scene_ = open_scene(kCube, sets_);
  Gpu gpu_;
};

}  // namespace

TEST_CASE("trials measure every kind of elements with both integrators", "[refine]") {
  CubeRuns cube;
  const std::vector<Trial> trials = run_trials(cube());
  REQUIRE(trials.size() == 4);
  CHECK(cube.lines == 4);
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

  // One with other iterations takes the errors of mesh and time over.
  Proposal choice;
  choice.iterations = 15;
  const std::optional<Trial> more = run_trial(cube(), choice, &trials[0]);
  REQUIRE(more);
  CHECK(more->few == 5);
  CHECK(more->many == 15);
  CHECK(more->mesh == trials[0].mesh);
  CHECK(more->time == trials[0].time);
  CHECK(more->solver_many <= trials[0].solver_many);
  choice.iterations = 3;
  const std::optional<Trial> less = run_trial(cube(), choice, &trials[0]);
  REQUIRE(less);
  CHECK(less->few == 3);
  CHECK(less->many == 10);
  CHECK(less->solver_few >= trials[0].solver_few);

  CubeRuns descent({"solver.method=vertex_descent"}, 2);
  CHECK(run_trials(descent()).size() == 2);
}
