// Static equilibria: closed forms, load paths, and bodies without an equilibrium.
#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/reference/elasticity.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::at_left_end;
using test::box_model;
using test::on_surface;
using test::soft;

const Vector3d cube(0.1, 0.1, 0.1);
NewtonReport settle(const Model& model, State& state) { return NewtonSolver(model, {}).solve_static(state); }

TEST_CASE("an affine motion of the surface is affine inside, with the energy and reaction of the closed form",
          "[static]") {
  for (const double nu : {-0.9, 0.0, 0.3, 0.499}) {
    Model model = box_model(4, 4, 4, cube, soft(1e5, nu));
    Matrix3d f;
    f << 1.3, 0.2, 0, -0.1, 0.9, 0.1, 0, 0.3, 1.1;
    Motion motion;
    motion.vertices = test::vertices_where(model, on_surface(cube));
    for (const std::uint32_t v : motion.vertices) motion.targets.push_back(f * model.rest_positions[v]);
    motion.duration = 2;
    model.motions = {motion};
    State state = initial_state(model);
    const NewtonReport report = settle(model, state);
    CAPTURE(nu, report.iterations, report.relative_residual);
    CHECK(report.converged);
    CHECK(state.time == 2);
    for (std::size_t v = 0; v < state.displacement.size(); ++v)
      CHECK((model.rest_positions[v] + state.displacement[v] - f * model.rest_positions[v]).norm() < 1e-10 * 0.1);

    const Matrix3d strain = 0.5 * (f.transpose() * f - Matrix3d::Identity());
    const double lambda = model.materials[0].lame_lambda(), mu = model.materials[0].lame_mu();
    const double density = 0.5 * lambda * strain.trace() * strain.trace() + mu * strain.squaredNorm();
    const Measures measures = measure(model, state);
    CHECK(measures.elastic == Approx(1e-3 * density).epsilon(1e-9));
    CHECK(measures.min_det_f == Approx(f.determinant()).epsilon(1e-8));
    CHECK(measures.max_det_f == Approx(f.determinant()).epsilon(1e-8));
    CHECK(measures.fixed_reaction.norm() < 1e-9 * 1e5 * 0.01);  // the surface as a whole is in equilibrium
  }
}

TEST_CASE("an equilibrium at a time has the motions of that time, from rest as from an earlier one", "[static]") {
  Model model = box_model(3, 3, 3, cube, soft(1e5, 0.3), at_left_end);
  Motion motion;
  motion.vertices = test::vertices_where(model, [](const Vector3d& x) { return x.x() > 0.1 - 1e-9; });
  motion.translate = {0.02, 0.01, 0};
  motion.start = 1;
  motion.duration = 2;
  model.motions = {motion};
  Model ended = model;
  ended.motions[0].translate *= 0.75;
  State expected = initial_state(model), straight = expected, stepped = expected;
  REQUIRE(settle(ended, expected).converged);
  NewtonSolver solver(model, {});
  REQUIRE(solver.solve_static(straight, 0, 2.5).converged);
  for (const double time : {0.0, 1.5, 2.5}) {
    REQUIRE(solver.solve_static(stepped, 0, time).converged);
    CHECK(stepped.time == time);
  }
  for (const State* state : {&straight, &stepped}) {
    CHECK(state->time == 2.5);
    CHECK((test::flat(state->displacement) - test::flat(expected.displacement)).norm() < 1e-9);
  }
  REQUIRE(solver.solve_static(straight).converged);
  CHECK(straight.time == 3);
}

TEST_CASE("a surface turned once around and moved carries the body along unstrained", "[static]") {
  Model model = box_model(3, 3, 3, cube, soft(1e5, 0.45));
  Motion motion;
  motion.vertices = test::vertices_where(model, on_surface(cube));
  motion.axis = Vector3d(1, 2, -1).normalized();
  motion.angle = 4;
  motion.translate = {3, 1, -2};
  model.motions = {motion};
  State state = initial_state(model);
  CHECK(settle(model, state).converged);
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    CHECK((model.rest_positions[v] + state.displacement[v] - motion.position(0, model.rest_positions[v], 1)).norm() <
          1e-10);
  CHECK(measure(model, state).elastic < 1e-12);
}

TEST_CASE("the pull on a stretched bar is reported separately from its support", "[static]") {
  const double young = 1e5, side = 0.1, length = 0.4, stretch = 1.3;
  Model model = box_model(8, 2, 2, {length, side, side}, soft(young), at_left_end);
  for (Material& material : model.materials) material.poisson_ratio = 0;
  model.bodies = {{"bar",
                   0,
                   static_cast<std::uint32_t>(model.rest_positions.size()),
                   0,
                   static_cast<std::uint32_t>(model.tets.size()),
                   0,
                   1,
                   {}}};
  Motion motion;
  motion.vertices = test::vertices_where(model, [&](const Vector3d& x) { return x.x() > length - 1e-9; });
  motion.translate = {(stretch - 1) * length, 0, 0};
  model.motions = {motion};
  State state = initial_state(model);
  REQUIRE(settle(model, state).converged);
  const std::vector<Support> supports = support_forces(model, state);
  REQUIRE(supports.size() == 2);
  CHECK((supports[0].body == 0 && !supports[0].motion && supports[1].body == 0 && supports[1].motion == 0));
  const Vector3d pull(young * stretch * (stretch * stretch - 1) / 2 * side * side, 0,
                      0);  // nominal stress F S of uniaxial Green strain
  CAPTURE(supports[0].force.transpose(), supports[1].force.transpose(), pull.x());
  CHECK((supports[1].force - pull).norm() < 1e-9 * pull.x());
  CHECK((supports[0].force + pull).norm() < 1e-9 * pull.x());
  CHECK((supports[0].force + supports[1].force - measure(model, state).fixed_reaction).norm() < 1e-9 * pull.x());
}

TEST_CASE("a full turn of one end is a twist, because the motion is followed along its path", "[static]") {
  for (const double duration : {0.0, 1.0}) {
    Model model = box_model(24, 2, 2, {1.2, 0.1, 0.1}, soft(1e5), at_left_end);
    Motion motion;
    motion.vertices = test::vertices_where(model, [](const Vector3d& x) { return x.x() > 1.199; });
    motion.center = {0, 0.05, 0.05};
    motion.angle = 2 * M_PI;
    motion.duration = duration;
    model.motions = {motion};
    State state = initial_state(model);
    CHECK(settle(model, state).converged);
    const Measures measures = measure(model, state);
    CAPTURE(duration, measures.elastic, measures.min_det_f);
    CHECK(measures.elastic > 0.1);
    CHECK(measures.inverted == 0);
  }
}

TEST_CASE("supports carry the weight", "[static]") {
  Model model = box_model(6, 2, 2, {0.4, 0.1, 0.1}, soft(1e5), at_left_end);
  model.gravity = {0, -9.81, 0};
  State state = initial_state(model);
  const NewtonReport report = settle(model, state);
  CHECK(report.converged);
  CHECK(report.relative_residual < 1e-10);
  const Vector3d weight = -4.0 * model.gravity;  // 0.4 * 0.1 * 0.1 m^3 of 1000 kg/m^3
  const Measures measures = measure(model, state);
  CAPTURE(measures.fixed_reaction.transpose());
  CHECK((measures.fixed_reaction - weight).norm() < 1e-9 * weight.norm());
  CHECK(measures.kinetic == 0);
  CHECK(measures.elastic > 0.1);

  SECTION("and solving again changes nothing") {
    const State before = state;
    CHECK(settle(model, state).iterations <= 1);
    CHECK((test::flat(state.displacement) - test::flat(before.displacement)).norm() < 1e-12);
  }
  SECTION("and a single endless step leads there") {
    SolverSettings endless;
    endless.time_step = 1e6;
    State moved = initial_state(model);
    CHECK(NewtonSolver(model, endless).step(moved).converged);
    CHECK((test::flat(moved.displacement) - test::flat(state.displacement)).norm() <
          1e-8 * test::flat(state.displacement).norm());
  }
  SECTION("and it is reached from any nearby state") {
    test::Random random(31);
    State moved = initial_state(model);
    const std::vector<char> held = model.held();
    for (std::size_t v = 0; v < held.size(); ++v)
      if (!held[v]) moved.displacement[v] = 0.005 * random.vector();
    CHECK(settle(model, moved).converged);
    CHECK((test::flat(moved.displacement) - test::flat(state.displacement)).norm() <
          1e-8 * test::flat(state.displacement).norm());
  }
}

TEST_CASE("stiffness does not change the result of a motion, and near nu = 0.5 the volume is constant", "[static]") {
  Eigen::VectorXd soft_displacement;
  for (const double young_modulus : {1e2, 1e9}) {
    Model model = box_model(4, 2, 2, {0.2, 0.1, 0.1}, soft(young_modulus, 0.499), at_left_end);
    Motion motion;
    motion.vertices = test::vertices_where(model, [](const Vector3d& x) { return x.x() > 0.199; });
    motion.translate = {0.06, 0, 0};
    motion.duration = 1;
    model.motions = {motion};
    State state = initial_state(model);
    CHECK(settle(model, state).converged);
    const Measures measures = measure(model, state);
    CAPTURE(young_modulus, measures.min_det_f, measures.max_det_f);
    CHECK(measures.inverted == 0);
    if (soft_displacement.size() == 0) soft_displacement = test::flat(state.displacement);
    CHECK((test::flat(state.displacement) - soft_displacement).norm() < 1e-9 * soft_displacement.norm());
  }
}

TEST_CASE("a body without a free vertex follows its motion", "[static]") {
  Model model = box_model(1, 1, 1, cube, soft(1e5));
  model.gravity = {0, -9.81, 0};
  Motion motion;
  motion.vertices = test::vertices_where(model, on_surface(cube));
  REQUIRE(motion.vertices.size() == 8);
  motion.translate = {1, 0, 0};
  model.motions = {motion};
  State fixed = initial_state(model), moved = fixed;
  CHECK(settle(model, fixed).converged);
  CHECK(NewtonSolver(model, {}).step(moved).converged);
  for (std::size_t v = 0; v < 8; ++v) {
    CHECK((fixed.displacement[v] - Vector3d(1, 0, 0)).norm() < 1e-15);
    CHECK((moved.displacement[v] - Vector3d(1, 0, 0)).norm() < 1e-15);
  }
}

TEST_CASE("a given tolerance is met", "[static]") {
  Model model = box_model(6, 2, 2, {0.4, 0.1, 0.1}, soft(2e4), at_left_end);
  model.gravity = {0, -9.81, 0};
  State rough = initial_state(model), fine = rough;
  const NewtonReport early = NewtonSolver(model, {}).solve_static(rough, 1e-2);
  const NewtonReport late = NewtonSolver(model, {}).solve_static(fine, 1e-9);
  CAPTURE(early.iterations, early.relative_residual, late.iterations, late.relative_residual);
  CHECK(early.relative_residual <= 1e-2);
  CHECK(early.relative_residual > 1e-9);
  CHECK(late.relative_residual <= 1e-9);
  CHECK(early.iterations < late.iterations);
}

TEST_CASE("an unconstrained component has no equilibrium under gravity", "[static]") {
  Model model = box_model(2, 1, 1, {0.2, 0.1, 0.1}, soft(1e5));
  model.gravity = {0, -9.81, 0};
  model.bodies = {{"slab",
                   0,
                   static_cast<std::uint32_t>(model.rest_positions.size()),
                   0,
                   static_cast<std::uint32_t>(model.tets.size()),
                   0,
                   1,
                   {}}};
  State state = initial_state(model);
  CHECK_THROWS_WITH(settle(model, state), Catch::Contains("slab") && Catch::Contains("unconstrained"));
  model.gravity.setZero();
  CHECK(settle(model, state).converged);
  CHECK(test::flat(state.displacement).norm() == 0);
}

}  // namespace
}  // namespace fascia::reference
