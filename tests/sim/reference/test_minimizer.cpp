// Newton's method with backtracking on problems whose minimum is known.
#include "sim/reference/minimizer.h"

#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Potential statics(const ElasticSystem& system, VectorXd force) {
  const auto size = static_cast<Eigen::Index>(3 * system.first_dof().size());
  return {{}, VectorXd::Zero(size), VectorXd::Zero(size), VectorXd::Zero(size), std::move(force)};
}

double energy(const ElasticSystem& system, const Potential& potential, const VectorXd& u) {
  VectorXd gradient;
  const VectorXd away = u - potential.target;
  return system.evaluate(u, potential.viscous, gradient) + 0.5 * away.dot(potential.inertia.cwiseProduct(away)) -
         potential.force.dot(u);
}

const Minimizer::Limits kLimits{100, false, {}};

}  // namespace

TEST_CASE("a force made of a known deformation gives that deformation back") {
  const Model model = test::box_model(3, 2, 2, {0.3, 0.2, 0.2}, test::soft(1e4), test::at_left_end);
  const ElasticSystem system(model);
  VectorXd known(static_cast<Eigen::Index>(3 * model.rest_positions.size()));
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {  // bent by about a tenth; zero at held vertices
    const double x = model.rest_positions[v].x();
    known.segment<3>(static_cast<Eigen::Index>(3 * v)) = Vector3d(0.1 * x, 0.5 * x * x, -0.2 * x * x);
  }
  VectorXd force;
  system.evaluate(known, {}, force);
  Minimizer minimizer(system);
  VectorXd u = VectorXd::Zero(known.size());
  const NewtonReport report = minimizer.minimize(statics(system, force), 1e-12, kLimits, u);
  CAPTURE(report.iterations, report.relative_residual, (u - known).norm() / known.norm());
  CHECK(report.converged);
  CHECK(report.iterations < 20);
  CHECK((u - known).norm() < 1e-9 * known.norm());
}

TEST_CASE("inertia without elastic forces leads to the target plus force over inertia") {
  Model model = test::box_model(1, 1, 1, {1, 1, 1}, test::soft(1e-3));
  const ElasticSystem system(model);
  const Eigen::Index size = 24;
  Potential potential = statics(system, VectorXd::Zero(size));
  potential.inertia.setConstant(1e6);  // large against a stiffness of a thousandth
  potential.target = VectorXd::LinSpaced(size, -0.01, 0.02);
  potential.start = potential.target;
  potential.force.setConstant(5e3);
  VectorXd u = VectorXd::Zero(size);
  Minimizer minimizer(system);
  const NewtonReport report = minimizer.minimize(potential, 1e-13, kLimits, u);
  const double error = (u - potential.target - VectorXd::Constant(size, 5e-3)).norm();
  CAPTURE(report.iterations, error);
  CHECK(report.converged);
  CHECK(error < 1e-8 * u.norm());
}

TEST_CASE("a minimizer that has solved a problem solves a neighboring one as a new minimizer does") {
  const Model model = test::box_model(3, 2, 2, {0.3, 0.2, 0.2}, test::soft(1e4, 0.4), test::at_left_end);
  const ElasticSystem system(model);
  test::Random random(5);
  const auto size = static_cast<Eigen::Index>(3 * model.rest_positions.size());
  Potential first = statics(system, 0.3 * random.vector(size));
  first.inertia.setConstant(50);
  Potential near = first, heavier = first;
  near.force *= 1.1;
  heavier.inertia *= 2;  // the factor is of no use
  Minimizer used(system);
  for (const Potential& potential : {first, near, heavier, near}) {
    VectorXd u = VectorXd::Zero(size), alone = u;
    const NewtonReport again = used.minimize(potential, 1e-12, kLimits, u);
    const NewtonReport fresh = Minimizer(system).minimize(potential, 1e-12, kLimits, alone);
    CAPTURE(again.iterations, fresh.iterations, again.relative_residual, (u - alone).norm() / alone.norm());
    CHECK(again.converged);
    CHECK(again.relative_residual <= 1e-12);
    CHECK((u - alone).norm() < 1e-11 * alone.norm());
  }
}

TEST_CASE("the result is a minimum: every small step away from it costs energy") {
  const Model model = test::box_model(2, 1, 1, {0.2, 0.1, 0.1}, test::soft(1e4, 0.4), test::at_left_end);
  const ElasticSystem system(model);
  test::Random random(3);
  const auto size = static_cast<Eigen::Index>(3 * model.rest_positions.size());
  Potential potential = statics(system, random.vector(size));
  potential.inertia.setConstant(50);
  potential.target = 0.02 * random.vector(size);
  potential.start = potential.target;
  VectorXd u = VectorXd::Zero(size);
  Minimizer minimizer(system);
  REQUIRE(minimizer.minimize(potential, 1e-12, kLimits, u).converged);
  for (const std::uint32_t v : model.fixed) CHECK(u.segment<3>(3 * v).norm() == 0);  // held vertices stay
  const double least = energy(system, potential, u);
  for (int i = 0; i < 50; ++i) {
    VectorXd away = u;
    system.add_to_free(random.vector(system.dof_count()).normalized(), 1e-3, away);
    const double more = energy(system, potential, away) - least;
    CAPTURE(i, least, more);
    CHECK(more > 0);
  }
}

TEST_CASE("the work ends at the limit of iterations, at a request, and where a tet turns inside out") {
  const Model model = test::box_model(2, 1, 1, {0.2, 0.1, 0.1}, test::soft(1e4), test::at_left_end);
  const ElasticSystem system(model);
  const auto size = static_cast<Eigen::Index>(3 * model.rest_positions.size());
  const Potential pulled = statics(system, VectorXd::Constant(size, 2));
  Minimizer minimizer(system);
  VectorXd u = VectorXd::Zero(size);
  NewtonReport report = minimizer.minimize(pulled, 1e-12, {1, false, {}}, u);
  CHECK(report.iterations == 1);
  CHECK_FALSE(report.converged);
  CHECK(report.relative_residual > 1e-12);

  std::stop_source stop;
  stop.request_stop();
  u.setZero();
  report = minimizer.minimize(pulled, 1e-12, {100, false, stop.get_token()}, u);
  CHECK(report.iterations == 0);
  CHECK_FALSE(report.converged);
  CHECK(u.norm() == 0);

  VectorXd mirrored = VectorXd::Zero(size);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    mirrored[static_cast<Eigen::Index>(3 * v)] = -2 * model.rest_positions[v].x();
  REQUIRE(system.min_det_f(mirrored) < 0);
  report = minimizer.minimize(pulled, 1e-12, {100, true, {}}, mirrored);
  CHECK(report.iterations == 0);
  CHECK_FALSE(report.converged);
}

TEST_CASE("free vertices follow moving held vertices, unless staying costs less energy") {
  const Model model = test::box_model(3, 1, 1, {0.3, 0.1, 0.1}, test::soft(1e4), test::at_left_end);
  const ElasticSystem system(model);
  const auto size = static_cast<Eigen::Index>(3 * model.rest_positions.size());
  const Potential nothing = statics(system, VectorXd::Zero(size));
  VectorXd change = VectorXd::Zero(size);
  for (const std::uint32_t v : model.fixed) change.segment<3>(3 * v) = Vector3d(0.01, -0.02, 0.005);
  Minimizer minimizer(system);
  VectorXd u = VectorXd::Zero(size);
  minimizer.move_held(nothing, change, u);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    CAPTURE(v);
    CHECK((u.segment<3>(static_cast<Eigen::Index>(3 * v)) - Vector3d(0.01, -0.02, 0.005)).norm() < 1e-12);
  }

  // A linear step may not fit half a turn: the energy is at most that of staying.
  for (const std::uint32_t v : model.fixed) {
    const Vector3d arm = model.rest_positions[v] - Vector3d(0, 0.05, 0.05);
    change.segment<3>(3 * v) = Vector3d(0, -2 * arm.y(), -2 * arm.z());
  }
  u.setZero();
  minimizer.move_held(nothing, change, u);
  CAPTURE(system.free_part(u).norm(), system.min_det_f(u));
  for (const std::uint32_t v : model.fixed) CHECK(u.segment<3>(3 * v) == change.segment<3>(3 * v));
  VectorXd gradient;
  CHECK(system.evaluate(u, {}, gradient) <= system.evaluate(change, {}, gradient));
}

}  // namespace fascia::reference
