// Implicit Euler steps: optimality, closed forms, conservation laws, damping, prescribed motion.
// Covers: held_path
#include "sim/reference/newton.h"

#include <catch2/catch.hpp>

#include "sim/material/symmetric_eigen.h"
#include "sim/reference/elasticity.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::at_left_end;
using test::box_model;
using test::Random;
using test::soft;

SolverSettings time_step(double dt, int substeps = 1) {
  SolverSettings settings;
  settings.time_step = dt;
  settings.substeps = substeps;
  return settings;
}

State disturbed(const Model& model, double displacement, double velocity, unsigned seed) {
  Random random(seed);
  State state = initial_state(model);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) {
      state.displacement[v] = displacement * random.vector();
      state.velocity[v] = velocity * random.vector();
    }
  return state;
}

double largest(const std::vector<Vector3d>& vectors) { return test::flat(vectors).cwiseAbs().maxCoeff(); }

TEST_CASE("a step solves the equations of implicit Euler", "[newton]") {
  for (const double nu : {-0.9, 0.0, 0.3, 0.49, 0.499})
    for (const double damping : {0.0, 0.05}) {
      Model model = box_model(3, 2, 2, {0.3, 0.2, 0.2}, soft(5e4, nu, damping), at_left_end);
      model.gravity = {1, -9.81, 2};
      const State before = disturbed(model, 0.004, 0.5, 21);
      State after = before;
      const double h = 1.0 / 60;
      const NewtonReport report = NewtonSolver(model, time_step(h)).step(after);
      CAPTURE(nu, damping, report.iterations, report.relative_residual);
      CHECK(report.converged);

      // The residual, computed independently from the tets.
      const std::vector<double> mass = consistent_masses(model);
      std::vector<Vector3d> force(mass.size(), Vector3d::Zero());
      double force_size = 0;
      for (std::size_t t = 0; t < model.tets.size(); ++t) {
        Corners rest, old, now;
        for (int a = 0; a < 4; ++a) {
          rest[a] = model.rest_positions[model.tets[t][a]];
          old[a] = before.displacement[model.tets[t][a]];
          now[a] = after.displacement[model.tets[t][a]];
        }
        const LinearTet tet(rest);
        const Vector12d gradient =
            elastic(tet, now, model.materials[0], damping / h, green_strain_matrix(tet, old), false, false).gradient;
        force_size += gradient.norm();
        for (int a = 0; a < 4; ++a) force[model.tets[t][a]] -= gradient.segment<3>(3 * a);
      }
      const std::vector<char> held = model.held();
      double worst = 0;
      for (std::size_t v = 0; v < mass.size(); ++v) {
        if (held[v]) {
          CHECK(after.displacement[v] == before.displacement[v]);
          continue;
        }
        CHECK((after.displacement[v] - before.displacement[v] - h * after.velocity[v]).norm() < 1e-16);
        const Vector3d change = mass[v] * (after.velocity[v] - before.velocity[v]) / h - mass[v] * model.gravity;
        worst = std::max(worst, (change - force[v]).norm());
      }
      CAPTURE(worst, force_size);
      CHECK(worst < 1e-12 * force_size);
      CHECK(after.time == Approx(h).epsilon(1e-15));
    }
}

TEST_CASE("rest stays at rest, and a rigid rotation causes no force", "[newton]") {
  Model model = box_model(2, 2, 2, {0.1, 0.1, 0.1}, soft(1e6, 0.45, 0.01));
  State state = initial_state(model);
  NewtonSolver solver(model, time_step(1.0 / 60));
  for (int k = 0; k < 3; ++k) REQUIRE(solver.step(state).converged);
  CHECK(largest(state.displacement) == 0);
  CHECK(largest(state.velocity) == 0);

  Random random(22);
  const Matrix3d turn = random.rotation();
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    state.displacement[v] = turn * model.rest_positions[v] + Vector3d(1, 2, 3) - model.rest_positions[v];
  REQUIRE(solver.step(state).converged);
  CHECK(largest(state.velocity) < 1e-12);
}

TEST_CASE("free fall follows the sum of implicit Euler for gravity", "[newton]") {
  Model model = box_model(2, 1, 1, {0.2, 0.1, 0.1}, soft(1e4));
  model.gravity = {0, -9.81, 0};
  State state = initial_state(model);
  const double h = 1.0 / 60;
  NewtonSolver solver(model, time_step(h));
  const int steps = 20;
  for (int n = 0; n < steps; ++n) REQUIRE(solver.step(state).converged);
  const Vector3d expected = model.gravity * h * h * steps * (steps + 1) / 2;
  for (const Vector3d& u : state.displacement) CHECK((u - expected).norm() < 1e-12 * expected.norm());
  for (const Vector3d& v : state.velocity) CHECK((v - steps * h * model.gravity).norm() < 1e-11 * 9.81);
}

// Newton's third law conserves linear momentum exactly. For the angular momentum L = sum x cross m v, a step without
// torque keeps sum x_{n+1} cross m v_n, so that with x_{n+1} = x_n + h v_{n+1}:  L_{n+1} - L_n = h sum v_{n+1} cross m
// v_n.
TEST_CASE("free bodies keep momentum, and lose as much angular momentum as implicit Euler must", "[newton]") {
  for (const double damping : {0.0, 0.03}) {
    const Model model = box_model(3, 2, 1, {0.3, 0.2, 0.1}, soft(2e4, 0.4, damping));
    State state = disturbed(model, 0.005, 0.3, 23);
    for (std::size_t v = 0; v < state.velocity.size(); ++v)
      state.velocity[v] += Vector3d(1, 2, 3) + Vector3d(0, 3, 5).cross(model.rest_positions[v]);
    const std::vector<double> mass = consistent_masses(model);
    const double h = 1.0 / 100;
    NewtonSolver solver(model, time_step(h));
    const Measures start = measure(model, state);
    double lost = 0;
    for (int n = 0; n < 10; ++n) {
      const State old = state;
      const Measures before = measure(model, state);
      REQUIRE(solver.step(state).converged);
      const Measures after = measure(model, state);
      Vector3d expected = before.angular_momentum;
      for (std::size_t v = 0; v < mass.size(); ++v) expected += h * state.velocity[v].cross(mass[v] * old.velocity[v]);
      CAPTURE(damping, n, after.angular_momentum.transpose(), expected.transpose());
      CHECK((after.momentum - start.momentum).norm() < 1e-11 * start.momentum.norm());
      CHECK((after.angular_momentum - expected).norm() < 1e-11 * start.angular_momentum.norm());
      lost += (after.angular_momentum - before.angular_momentum).norm();
    }
    CHECK(lost > 1e-6 * start.angular_momentum.norm());  // else indistinguishable from conservation
  }
}

// Minimizing the step's potential from u_n guarantees a decrease of U + |v - v_n|^2 / 2; where the energy is convex
// between the two states, as in vibrations like this one, the total energy decreases as well.
TEST_CASE("without input the total energy never grows", "[newton]") {
  for (const double nu : {-0.9, 0.3, 0.499}) {
    Model model = box_model(4, 2, 2, {0.4, 0.1, 0.1}, soft(1e5, nu), at_left_end);
    State state = disturbed(model, 0.002, 1.0, 24);
    NewtonSolver solver(model, time_step(1.0 / 240));
    double energy = measure(model, state).kinetic + measure(model, state).elastic;
    const double start = energy;
    for (int n = 0; n < 40; ++n) {
      REQUIRE(solver.step(state).converged);
      const Measures now = measure(model, state);
      CAPTURE(nu, n, now.kinetic, now.elastic, energy);
      CHECK(now.kinetic + now.elastic <= energy * (1 + 1e-12));
      energy = now.kinetic + now.elastic;
    }
    CHECK(energy < 0.9 * start);
  }
}

// One free corner, with a motion so small that it is linear: along an eigenvector of the stiffness K each step obeys
// (u+ - u - h v) / h^2 + w2 (u+ + damping/h (u+ - u)) = 0, w2 = k / m.
TEST_CASE("a small vibration of one vertex follows the damped recurrence", "[newton]") {
  for (const double damping : {0.0, 1e-3, 0.02}) {
    Model model;
    model.rest_positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
    model.tets = {{0, 1, 2, 3}};
    model.tet_material = {0};
    model.materials = {soft(1e4, 0.3, damping)};
    model.fixed = {0, 1, 2};
    model.gravity.setZero();
    model.initial_velocity.assign(4, Vector3d::Zero());
    const LinearTet rest(
        {model.rest_positions[0], model.rest_positions[1], model.rest_positions[2], model.rest_positions[3]});
    Corners still;
    still.fill(Vector3d::Zero());
    const Matrix3d stiffness =
        elastic(rest, still, model.materials[0], 0, Matrix3d::Zero(), true, false).hessian.block<3, 3>(9, 9);
    const SymmetricEigen eigen = symmetric_eigen(stiffness);
    const Vector3d mode = eigen.vectors.col(2);
    const double w2 = eigen.values[2] / lumped_masses(model)[3], h = 0.1 / std::sqrt(w2);

    State state = initial_state(model);
    const double amplitude = 1e-9;
    state.displacement[3] = amplitude * mode;
    double u = amplitude, v = 0;
    NewtonSolver solver(model, time_step(h));
    for (int n = 0; n < 50; ++n) {
      REQUIRE(solver.step(state).converged);
      const double next = (u + h * v + h * w2 * damping * u) / (1 + h * h * w2 + h * w2 * damping);
      v = (next - u) / h;
      u = next;
      CAPTURE(damping, n, u, state.displacement[3].transpose());
      // Quadratic terms are amplitude / size = 1e-8 of the linear ones.
      CHECK((state.displacement[3] - u * mode).norm() < 1e-6 * amplitude);
    }
  }
}

TEST_CASE("damping takes energy out of a vibration, the more the higher its frequency", "[newton]") {
  double previous = std::numeric_limits<double>::infinity();
  for (const double damping : {0.0, 0.01, 0.04, 0.1}) {
    Model model = box_model(6, 1, 1, {0.3, 0.05, 0.05}, soft(1e5, 0.3, damping), at_left_end);
    State state = initial_state(model);
    for (std::size_t v = 0; v < state.velocity.size(); ++v)
      state.velocity[v] = Vector3d(0, 0, 2) * model.rest_positions[v].x();
    NewtonSolver solver(model, time_step(1.0 / 120));
    for (int n = 0; n < 12; ++n) REQUIRE(solver.step(state).converged);
    const Measures now = measure(model, state);
    CAPTURE(damping, now.kinetic, now.elastic, previous);
    CHECK(now.kinetic + now.elastic < 0.9 * previous);
    previous = now.kinetic + now.elastic;
  }
}

TEST_CASE("a drawn-out bar returns within some times of its damping, however incompressible it is", "[newton]") {
  for (const auto& [nu, quadratic] : {std::pair{0.3, false}, {0.45, false}, {0.495, false}, {0.495, true}}) {
    Material material = soft(1e5, nu, 0.01);
    material.model = MaterialModel::squared;
    Model model = box_model(6, 2, 2, {0.2, 0.05, 0.05}, material, at_left_end);
    if (quadratic) model = test::quadratic(model);
    State state = initial_state(model);
    for (std::size_t v = 0; v < state.displacement.size(); ++v) {
      const Vector3d at = model.rest_positions[v];
      const double lateral = 1 / std::sqrt(1.5) - 1;
      if (at.x() > 1e-9) state.displacement[v] = {0.5 * at.x(), lateral * (at.y() - 0.025), lateral * (at.z() - 0.025)};
    }
    const double before = measure(model, state).elastic;
    NewtonSolver solver(model, time_step(1.0 / 60));
    for (int n = 0; n < 9; ++n) {
      const NewtonReport report = solver.step(state);
      CAPTURE(nu, quadratic, n, report.iterations, report.relative_residual, measure(model, state).elastic);
      REQUIRE(report.converged);
    }
    CAPTURE(nu, quadratic, before, measure(model, state).elastic);
    CHECK(measure(model, state).elastic < 0.02 * before);
  }
}

TEST_CASE("a step under a small load ends where its forces are rounded", "[newton]") {
  for (const MaterialModel law : {MaterialModel::squared, MaterialModel::neo_hookean, MaterialModel::mooney_rivlin,
                                  MaterialModel::stable_neo_hookean})
    for (const bool quadratic : {false, true}) {
      Material material = soft(2e6);
      material.model = law;
      Model model = box_model(10, 1, 2, {0.4, 0.02, 0.03}, material, at_left_end);
      if (quadratic) model = test::quadratic(model);
      model.gravity = {0, -0.01, 0};
      State state = initial_state(model);
      NewtonSolver solver(model, time_step(0.01));
      for (int n = 0; n < 4; ++n) {
        const NewtonReport report = solver.step(state);
        CAPTURE(static_cast<int>(law), quadratic, n, report.iterations, report.relative_residual);
        CHECK(report.converged);
        CHECK(report.relative_residual < 1e-8);
        CHECK(report.iterations < 20);  // without that bound 400
      }
    }
}

TEST_CASE("substeps are complete steps", "[newton]") {
  Model model = box_model(3, 1, 1, {0.3, 0.1, 0.1}, soft(1e5), at_left_end);
  model.gravity = {0, -9.81, 0};
  State whole = initial_state(model), parts = whole;
  const NewtonReport report = NewtonSolver(model, time_step(1.0 / 30, 4)).step(whole);
  NewtonSolver fine(model, time_step(1.0 / 120));
  int iterations = 0;
  for (int k = 0; k < 4; ++k) iterations += fine.step(parts).iterations;
  CHECK(test::flat(whole.displacement) == test::flat(parts.displacement));
  CHECK(test::flat(whole.velocity) == test::flat(parts.velocity));
  CHECK(whole.time == parts.time);
  CHECK(report.iterations == iterations);
}

TEST_CASE("prescribed vertices are on their path at every step and have its velocity", "[newton]") {
  Model model = box_model(8, 2, 2, {0.4, 0.1, 0.1}, soft(1e5), at_left_end);
  Motion motion;
  motion.vertices = test::vertices_where(model, [](const Vector3d& x) { return x.x() > 0.399; });
  motion.axis = {1, 0, 0};
  motion.center = {0, 0.05, 0.05};
  motion.angle = 1.5;
  motion.start = 0.05;
  motion.duration = 0.2;
  model.motions = {motion};
  State state = initial_state(model);
  const double h = 0.025;
  NewtonSolver solver(model, time_step(h));
  for (int n = 0; n < 14; ++n) {
    const State old = state;
    REQUIRE(solver.step(state).converged);
    for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
      const std::uint32_t v = motion.vertices[k];
      const Vector3d rest = model.rest_positions[v];
      CAPTURE(n, v, state.time);
      CHECK((rest + state.displacement[v] - motion.position(k, rest, state.time)).norm() < 1e-15);
      CHECK((state.velocity[v] - (state.displacement[v] - old.displacement[v]) / h).norm() < 1e-13);
    }
    CHECK(measure(model, state).min_det_f > 0.5);
  }
  CHECK(measure(model, state).elastic > 0.01);
}

TEST_CASE("a jump by half a rotation follows the arc", "[newton]") {
  Model model = box_model(8, 1, 1, {0.8, 0.1, 0.1}, soft(1e5), at_left_end);
  Motion motion;
  motion.vertices = test::vertices_where(model, [](const Vector3d& x) { return x.x() > 0.799; });
  motion.center = {0, 0.05, 0.05};
  motion.angle = M_PI;
  model.motions = {motion};
  State state = initial_state(model);
  // A step so long that inertia is negligible, so that the rotation is spread over the whole length.
  CHECK(NewtonSolver(model, time_step(1.0)).step(state).converged);
  const Measures now = measure(model, state);
  CAPTURE(now.min_det_f, now.max_det_f);
  CHECK(now.inverted == 0);
  CHECK(now.elastic > 0.1);
  const std::uint32_t v = motion.vertices[0];
  CHECK((model.rest_positions[v] + state.displacement[v] - motion.position(0, model.rest_positions[v], 1)).norm() <
        1e-15);
}

// Near the minimum energies of a stiff body that turns differ by rounding alone: 400 iterations then, its limit.
TEST_CASE("steps of a stiff body that spins end where rounding does", "[newton]") {
  const double young_modulus = GENERATE(1e6, 1e7);
  Material material = soft(young_modulus);
  material.model = MaterialModel::neo_hookean;
  material.poisson_ratio = 0.4;
  material.damping = 0.02;
  Model model = box_model(3, 3, 3, {0.04, 0.04, 0.04}, material, [](const Vector3d&) { return false; });
  model.gravity.setZero();
  State state = initial_state(model);
  for (std::size_t v = 0; v < state.velocity.size(); ++v)
    state.velocity[v] = Vector3d(0, 0, 10).cross(model.rest_positions[v] - Vector3d::Constant(0.02));
  NewtonSolver solver(model, time_step(1.0 / 60));
  for (int step = 0; step < 10; ++step) {
    const NewtonReport report = solver.step(state);
    CAPTURE(young_modulus, step, report.iterations, report.relative_residual);
    CHECK(report.converged);
    CHECK(report.iterations < 100);
    CHECK(report.relative_residual < 1e-8);
  }
}

}  // namespace
}  // namespace fascia::reference
