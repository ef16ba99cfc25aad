#include "app/refine/plan_text.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

Scene beam() {
  Scene scene;
  scene.bodies.emplace_back();
  return scene;
}

/// 192 quadratic tets, measured: 0.8 ms a step with an error of 0.5 %.
Proposal measured_choice() {
  Proposal p{ElementOrder::quadratic, Integrator::bdf2, 1, 192, 8, 30};
  p.mesh = 0.002;
  p.time = 0.003;
  p.ms = 0.8;
  p.measured = true;
  p.from_tets = 192;
  return p;
}

}  // namespace

TEST_CASE("a choice within reach is printed with its options") {
  Plan plan;
  plan.within = measured_choice();
  CHECK(plan_text(plan, beam(), {0.01, 1}) ==
        "for 1 % in 1 ms a step:\n"
        "  192 quadratic tets (edges as they are), bdf2, 8 substeps, 30 iterations\n"
        "  error 0.5 %: mesh 0.2 %, time 0.3 %, solver 0 %; 0.8 ms a step\n"
        "  --set elements=quadratic --set solver.integrator=bdf2 --set solver.substeps=8 --set solver.iterations=30\n");
}

TEST_CASE("an error that no choice has is said to be so, with the least one and what ended the search") {
  Plan plan;
  plan.fast = plan.best = plan.fastest = measured_choice();
  CHECK_THAT(plan_text(plan, beam(), {1e-4, 1, 512}),
             Catch::StartsWith("not within reach: 0.01 % in 1 ms a step\n"
                               "for the error: no choice; the least error found is 0.5 %: mesh 0.2 %, time 0.3 %, "
                               "solver 0 %; most of it in time; with 192 quadratic tets (edges as they are), bdf2, "
                               "8 substeps, 30 iterations, 0.8 ms a step; the search ends at 8 substeps, 30 iterations "
                               "and 512 times the tets\n"
                               "for the time:\n  192 quadratic tets"));
  plan.best->measured = false;
  plan.best->mesh = 0.1;
  plan.cut_off = true;
  CHECK_THAT(plan_text(plan, beam(), {1e-4, 1}),
             Catch::Contains("most of it in the mesh; ") &&
                 Catch::Contains("0.8 ms a step, extrapolated; the search ends after 16 runs\n"));
}

TEST_CASE("a time that no choice has is said to be so, and that no choice could be run") {
  Plan plan;
  plan.exact = plan.best = plan.fastest = measured_choice();
  CHECK_THAT(plan_text(plan, beam(), {0.01, 0.1}),
             Catch::Contains("for the error:\n  192 quadratic tets") &&
                 Catch::EndsWith("for the time: no choice; the fastest takes 0.8 ms a step, with 192 quadratic tets "
                                 "(edges as they are), bdf2, 8 substeps, 30 iterations and an error of 0.5 %\n"));
  CHECK(plan_text({}, beam(), {0.01, 0.1}) == "not within reach: 1 % in 0.1 ms a step\nno choice could be run\n");
}
