#include "app/refine/confirmed_plan.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <tuple>

using namespace fascia;

namespace {

/// Linear tets by BDF2 in a world in which the mesh's error falls with the edges only, half of it never, and finer
/// meshes leave the solver more to do.
struct World {
  int runs = 0;
  double finest = 0;
  std::vector<const Trial*> alike{};

  Trial trial(double refinement, int substeps, int iterations) {
    Trial trial;
    trial.integrator = Integrator::bdf2;
    trial.refinement = refinement;
    trial.tets = static_cast<std::size_t>(std::lround(1000 * std::pow(refinement, 3)));
    trial.substeps = substeps;
    trial.mesh = 0.1 / refinement + 0.02;
    trial.time = 0.01 / substeps;
    (iterations < trial.many ? trial.few : trial.many) = iterations;
    const auto solver = [&](int its) { return 0.1 * refinement * std::exp(-0.5 * its); };
    const auto ms = [&](int its) { return 1e-4 * static_cast<double>(trial.tets) * substeps * (2 + its); };
    trial.solver_few = solver(trial.few);
    trial.solver_many = solver(trial.many);
    trial.ms_few = ms(trial.few);
    trial.ms_many = ms(trial.many);
    return trial;
  }
  RunChoice run() {
    return [this](const Proposal& choice, const Trial* like) {
      ++runs;
      alike.push_back(like);
      finest = std::max(finest, choice.refinement);
      return trial(choice.refinement, choice.substeps, choice.iterations);
    };
  }
};

}  // namespace

TEST_CASE("what is proposed has been run on its mesh") {
  World world;
  std::vector<Trial> trials{world.trial(1, 1, 10)};
  const Plan guess = plan_for(trials, 0.08, 1e3);
  const Plan plan = confirmed_plan(trials, 0.08, 1e3, {usual_refinements(), true}, world.run());
  REQUIRE(guess.within);
  REQUIRE(plan.within);
  CAPTURE(guess.within->refinement, plan.within->refinement, plan.within->error(), world.runs);
  // Squares of the edges promise the error on a mesh that does not have it.
  CHECK(world.trial(guess.within->refinement, guess.within->substeps, 30).mesh > 0.08);
  CHECK(plan.within->measured);
  CHECK(measured(*plan.within, trials));
  CHECK(plan.within->error() <= 0.08);
  const Trial truth = world.trial(plan.within->refinement, plan.within->substeps, plan.within->iterations);
  CHECK(plan.within->mesh == Approx(truth.mesh));
  CHECK(plan.within->tets == static_cast<double>(truth.tets));
  CHECK(world.runs <= kMostRuns);
  CHECK(std::count(world.alike.begin(), world.alike.end(), nullptr) > 0);
}

TEST_CASE("an error out of reach is extrapolated, and says so, where its mesh is far finer") {
  World world;
  std::vector<Trial> trials{world.trial(1, 1, 10)};
  const Plan plan = confirmed_plan(trials, 0.01, 1, {usual_refinements(), true}, world.run());
  CHECK_FALSE(plan.within);
  REQUIRE(plan.fast);
  CHECK(plan.fast->measured);
  CHECK(plan.fast->ms <= 1);
  CHECK(world.finest <= 2.0001);
  // With 0.02 of the mesh's error left on every mesh, none is enough; squares of the edges promise one.
  REQUIRE(plan.exact);
  CHECK_FALSE(plan.exact->measured);
  CHECK(plan.exact->other_mesh);
  CHECK(plan.exact->refinement > kFinestRun);
  CHECK(plan.exact->from_tets == 8000);
}

TEST_CASE("with a mesh that cannot be made only the other choices are run") {
  World world;
  std::vector<Trial> trials{world.trial(1, 1, 10)};
  const Plan plan = confirmed_plan(trials, 0.06, 1e3, {}, world.run());
  REQUIRE(plan.within);
  CHECK(world.finest <= 1);
  CHECK(plan.within->other_mesh);
  CHECK(plan.within->from_tets == 1000);
  CHECK(std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
    return trial.substeps == plan.within->substeps &&
           (trial.few == plan.within->iterations || trial.many == plan.within->iterations);
  }));
}

TEST_CASE("of meshes that cannot be made, none with less than half of the tets is proposed") {
  World world;
  for (const bool made : {false, true}) {
    std::vector<Trial> trials{world.trial(1, 1, 10)};
    const Plan plan = confirmed_plan(trials, 0.9, 1e3, {usual_refinements(), made}, world.run());
    REQUIRE(plan.within);
    CAPTURE(made, plan.within->refinement, plan.within->tets);
    CHECK((plan.within->tets < 499) == made);
  }
}

TEST_CASE("a mesh on which the scene does not run is left out") {
  World world;
  std::vector<Trial> trials{world.trial(1, 1, 10)};
  const RunChoice run = world.run();
  const Plan plan = confirmed_plan(trials, 0.06, 1e3, {usual_refinements(), true},
                                   [&](const Proposal& choice, const Trial* like) -> std::optional<Trial> {
                                     if (choice.refinement > 1.1 && choice.refinement < 2.6) return std::nullopt;
                                     return run(choice, like);
                                   });
  REQUIRE(plan.within);
  CHECK(plan.within->measured);
  CHECK(plan.within->refinement >= 2.6);
}

TEST_CASE("no choice is run twice, also where runs do not confirm it") {
  World world;
  std::vector<Trial> trials{world.trial(1, 1, 10)};
  std::vector<std::tuple<double, int, int>> runs;
  const Plan plan = confirmed_plan(trials, 1e-3, 1e3, {usual_refinements(), false},
                                   [&](const Proposal& choice, const Trial*) -> std::optional<Trial> {
                                     runs.emplace_back(choice.refinement, choice.substeps, choice.iterations);
                                     Trial trial = world.trial(1, choice.substeps, choice.iterations);
                                     trial.few = 4;  // the choice is not among what was measured
                                     trial.many = 11;
                                     return trial;
                                   });
  for (const auto& [refinement, substeps, iterations] : runs) UNSCOPED_INFO(substeps << " x " << iterations);
  CHECK(std::set(runs.begin(), runs.end()).size() == runs.size());
  CHECK(runs.size() > 1);
  CHECK(plan.best);
}

TEST_CASE("a plan whose runs never confirm it is that of what was run, and says that it is cut off") {
  World world;
  std::vector<Trial> trials{world.trial(1, 1, 10)};
  int runs = 0;
  const Plan plan = confirmed_plan(trials, 0.06, 1e3, {usual_refinements(), true},
                                   [&](const Proposal&, const Trial*) -> std::optional<Trial> {
                                     ++runs;
                                     return world.trial(1, 1, 10);
                                   });
  CHECK(runs == kMostRuns);
  CHECK(plan.cut_off);
  CHECK_FALSE(plan.within);
  REQUIRE(plan.best);
  CHECK(plan.best->measured);
  CHECK_FALSE(confirmed_plan(trials, 0.9, 1e3, {usual_refinements(), true}, world.run()).cut_off);
}
