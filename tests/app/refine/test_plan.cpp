#include "app/refine/plan.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fascia;

namespace {

/// 5,000 tets at 100 ns per tet and iteration, and as much as two iterations beside them.
Trial trial_of(ElementOrder elements, Integrator integrator, double mesh, double time) {
  Trial trial;
  trial.elements = elements;
  trial.integrator = integrator;
  trial.tets = 5000;
  trial.mesh = mesh;
  trial.time = time;
  trial.order = integrator == Integrator::implicit_euler ? 1 : 2;
  trial.solver_few = 1e-2;
  trial.solver_many = 1e-4;
  trial.ms_few = 3.5;
  trial.ms_many = 6;
  return trial;
}

}  // namespace

TEST_CASE("a prediction for the measured choice is the measurement") {
  const Trial trial = trial_of(ElementOrder::linear, Integrator::bdf2, 0.1, 0.02);
  CHECK(trial.ns_per_tet_iteration() == Approx(100));
  const Proposal same = predicted(trial, 1, 1, 10), few = predicted(trial, 1, 1, 5);
  CHECK(same.mesh == Approx(0.1));
  CHECK(same.time == Approx(0.02));
  CHECK(same.ms == Approx(6));
  CHECK(few.solver == Approx(1e-2));
  CHECK(few.ms == Approx(3.5));
  CHECK(predicted(trial, 1, 1, 3).ms == Approx(2.5));
  CHECK(predicted(trial, 1, 4, 3).ms == Approx(10));
}

TEST_CASE("finer meshes, more substeps and more iterations cost what they save") {
  const Trial euler = trial_of(ElementOrder::linear, Integrator::implicit_euler, 0.1, 0.2),
              bdf2 = trial_of(ElementOrder::linear, Integrator::bdf2, 0.1, 0.02);
  const Proposal fine = predicted(euler, 2, 1, 10);
  CHECK(fine.tets == Approx(40000));
  CHECK(fine.mesh == Approx(0.025));
  CHECK(fine.ms == Approx(48));
  CHECK(predicted(euler, 1, 2, 10).time == Approx(0.1));
  CHECK(predicted(bdf2, 1, 2, 10).time == Approx(0.005));
  CHECK(predicted(bdf2, 1, 2, 10).ms == Approx(12));
  // To coarser meshes, quadratic elements lose what fourth powers of the edges say.
  CHECK(predicted(euler, 0.8, 1, 10).mesh == Approx(0.1 / 0.64));
  const Trial quadratic = trial_of(ElementOrder::quadratic, Integrator::bdf2, 0.01, 0.02);
  CHECK(predicted(quadratic, 2, 1, 10).mesh == Approx(0.0025));
  CHECK(predicted(quadratic, 0.5, 1, 10).mesh == Approx(0.16));
  Trial thick = euler;  // than the surface that its tets fill
  thick.shape = 0.3;
  CHECK(predicted(thick, 2, 1, 10).shape == Approx(0.075));
  CHECK(predicted(thick, 1, 1, 10).error() == Approx(predicted(euler, 1, 1, 10).error() + 0.3));
  Trial slow = bdf2, unresolved = bdf2;  // errors of contact fall more slowly
  slow.order = 0.75;
  unresolved.order = 0;
  CHECK(predicted(slow, 1, 4, 10).time == Approx(0.02 * std::pow(4, -0.75)));
  CHECK(predicted(unresolved, 1, 4, 10).time == Approx(0.01));
  // 1e-2 to 1e-4 in five iterations is a rate of 0.4; beyond the measured ones no better rate than 0.6 counts.
  CHECK(predicted(bdf2, 1, 1, 15).solver == Approx(1e-4 * std::pow(0.6, 5)));
}

TEST_CASE("the plan is the fastest choice within error and time, or says what each alone would take") {
  const std::vector<Trial> trials{trial_of(ElementOrder::linear, Integrator::implicit_euler, 0.1, 0.2),
                                  trial_of(ElementOrder::linear, Integrator::bdf2, 0.1, 0.02),
                                  trial_of(ElementOrder::quadratic, Integrator::bdf2, 0.01, 0.02)};
  const Plan plan = plan_for(trials, 0.03, 16);
  REQUIRE(plan.within);
  CAPTURE(plan.within->tets, plan.within->substeps, plan.within->iterations, plan.within->error(), plan.within->ms);
  CHECK(plan.within->elements == ElementOrder::quadratic);
  CHECK(plan.within->integrator == Integrator::bdf2);
  CHECK(plan.within->error() <= 0.03);
  CHECK(plan.within->ms <= 16);
  CHECK(plan.within->ms <= plan.exact->ms + 1e-12);

  const Plan none = plan_for(trials, 3e-3, 0.3);
  CHECK_FALSE(none.within);
  REQUIRE(none.exact);
  REQUIRE(none.fast);
  CHECK(none.exact->error() <= 3e-3);
  CHECK(none.exact->ms > 0.3);
  CHECK(none.fast->ms <= 0.3);
  CHECK(none.fast->error() > 3e-3);
  CHECK_FALSE(plan_for({}, 0.1, 10).fast);
}

TEST_CASE("a plan has the most accurate and the fastest choice of all, also where none is within reach") {
  const std::vector<Trial> trials{trial_of(ElementOrder::linear, Integrator::implicit_euler, 0.1, 0.2),
                                  trial_of(ElementOrder::quadratic, Integrator::bdf2, 0.01, 0.02)};
  const Plan plan = plan_for(trials, 1e-9, 1e-9);
  CHECK_FALSE(plan.exact);
  CHECK_FALSE(plan.fast);
  REQUIRE(plan.best);
  REQUIRE(plan.fastest);
  CHECK(plan.best->elements == ElementOrder::quadratic);
  // Not the least error of all, for a tenth of which a finer mesh or more iterations take times as long.
  const Proposal least = predicted(trials[1], 8, kMostSubsteps, kMostIterations);
  CHECK(plan.best->substeps == kMostSubsteps);
  CHECK(plan.best->error() <= 1.1 * least.error());
  CHECK(plan.best->ms < 0.7 * least.ms);
  CHECK(plan.fastest->substeps == 1);
  CHECK(plan.fastest->iterations == 3);
  CHECK(plan.fastest->refinement < 0.5);
  CHECK_FALSE(plan_for({}, 0.1, 10).best);
}

TEST_CASE("a choice follows from the trial whose substeps are next below its own") {
  Trial one = trial_of(ElementOrder::quadratic, Integrator::bdf2, 0, 0.4), four = one;
  four.substeps = 4;
  four.time = 0.1;  // the order would give 0.025
  four.ms_few = 14;
  four.ms_many = 24;
  // By the first trial alone, four substeps have an error of 0.025.
  const Plan early = plan_for({one}, 0.05, 1e3), late = plan_for({one, four}, 0.05, 1e3);
  REQUIRE(early.within);
  REQUIRE(late.within);
  CHECK(early.within->substeps == 4);
  CHECK(late.within->substeps == 8);
  CHECK(late.within->time == Approx(0.025));
  // Fewer substeps than any trial has follow from the one with the fewest.
  const Plan only = plan_for({four}, 2, 4);
  REQUIRE(only.within);
  CHECK(only.within->substeps < 4);
  CHECK(only.within->time == Approx(0.1 * std::pow(4.0 / only.within->substeps, 2)));
}

TEST_CASE("a choice follows from the trial with its substeps whose mesh is nearest") {
  Trial opened = trial_of(ElementOrder::linear, Integrator::bdf2, 0.2, 0.02), finer = opened, steps = opened;
  finer.refinement = 2;
  finer.tets = 38000;  // not quite eight times as many
  finer.mesh = 0.08;   // squares would give 0.05
  finer.ms_few = 30;
  finer.ms_many = 50;
  finer.solver_many = 3e-3;  // contact: more than on the coarse mesh
  steps.substeps = 2;
  const std::vector<Trial> trials{opened, finer, steps};
  const auto exact_of = [&](double error, double refinement) {
    const Plan plan = plan_for(trials, error, 1e9, {refinement}, [](const Proposal& p) { return p.substeps == 1; });
    REQUIRE(plan.fast);
    return *plan.fast;
  };
  const Proposal own = exact_of(1, 2), near = exact_of(1, 2.5), far = exact_of(1, 1.2);
  CHECK(own.mesh == Approx(0.08));
  CHECK(own.tets == 38000);
  CHECK_FALSE(own.other_mesh);
  CHECK(near.mesh == Approx(0.08 / (1.25 * 1.25)));
  CHECK(near.other_mesh);
  CHECK(near.from_tets == 38000);
  CHECK(far.mesh == Approx(0.2 / (1.2 * 1.2)));
  CHECK(far.from_tets == 5000);
  // Substeps count before the mesh.
  const Plan two = plan_for(trials, 1, 1e9, {2}, [](const Proposal& p) { return p.substeps == 2; });
  REQUIRE(two.fast);
  CHECK(two.fast->from_tets == 5000);
  CHECK(two.fast->mesh == Approx(0.05));
}

TEST_CASE("what a filled surface's volume is off is known for all elements from one run on a mesh") {
  Trial linear = trial_of(ElementOrder::linear, Integrator::bdf2, 0.2, 0.02);
  Trial quadratic = trial_of(ElementOrder::quadratic, Integrator::bdf2, 0.02, 0.02);
  linear.shape = quadratic.shape = 0.4;
  Trial fine = linear;
  fine.refinement = 2;
  fine.tets = 40000;
  fine.shape = 0.01;
  const auto shape_of = [&](const std::vector<Trial>& trials) {
    const Plan plan =
        plan_for(trials, 1, 1e9, {2}, [](const Proposal& p) { return p.elements == ElementOrder::quadratic; });
    REQUIRE(plan.fast);
    return plan.fast->shape;
  };
  CHECK(shape_of({linear, quadratic}) == Approx(0.1));
  CHECK(shape_of({linear, quadratic, fine}) == Approx(0.01));
}

TEST_CASE("a proposal is measured if a trial has all five of its choices, and then has its numbers") {
  Trial trial = trial_of(ElementOrder::linear, Integrator::bdf2, 0.2, 0.02);
  trial.refinement = 1.5;
  trial.few = 7;
  const Proposal few = predicted(trial, 1.5, 1, 7), many = predicted(trial, 1.5, 1, 10);
  for (const Proposal& same : {few, many}) {
    CHECK(same.measured);
    CHECK(measured(same, {trial}));
    CHECK(same.tets == 5000);
    CHECK(same.mesh == Approx(0.2));
    CHECK(same.time == Approx(0.02));
  }
  CHECK(few.solver == Approx(1e-2));
  CHECK(many.solver == Approx(1e-4));
  CHECK(few.ms == Approx(3.5));
  CHECK(many.ms == Approx(6));
  for (const Proposal& other :
       {predicted(trial, 1, 1, 10), predicted(trial, 1.5, 2, 10), predicted(trial, 1.5, 1, 5)}) {
    CHECK_FALSE(other.measured);
    CHECK_FALSE(measured(other, {trial}));
  }
  Proposal euler = few, quadratic = few;
  euler.integrator = Integrator::implicit_euler;
  quadratic.elements = ElementOrder::quadratic;
  CHECK_FALSE(measured(euler, {trial}));
  CHECK_FALSE(measured(quadratic, {trial}));
}

TEST_CASE("tets of bodies whose mesh stays are no more on a finer mesh") {
  Trial trial = trial_of(ElementOrder::linear, Integrator::bdf2, 0.2, 0.02);
  trial.kept = 4000;
  const Proposal finer = predicted(trial, 2, 1, 10);
  CHECK(finer.tets == Approx(4000 + 8 * 1000));
  CHECK(finer.ms == Approx(6 * 12000 / 5000.0));
}

TEST_CASE("a choice that no trial has is preferred only where it promises a tenth more") {
  Trial slow = trial_of(ElementOrder::linear, Integrator::bdf2, 0.01, 0.01), quick = slow;
  quick.elements = ElementOrder::quadratic;
  slow.few = quick.few = 10;
  slow.many = quick.many = 20;
  slow.ms_few = slow.ms_many = 10;
  // A trial with other substeps promises the same in less time.
  const auto chosen = [&](double ms) {
    quick.substeps = 2;
    quick.ms_few = quick.ms_many = 2 * ms;
    return *plan_for({slow, quick}, 0.1, 100, {1}, [](const Proposal& p) {
              return p.substeps == 1 && p.iterations == 10;
            }).within;
  };
  // 10 iterations of the quick one are measured, but not with one substep.
  CHECK(chosen(9.5).elements == ElementOrder::linear);
  CHECK(chosen(8).elements == ElementOrder::quadratic);
}
