#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/reference/elasticity.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::box_model;
using test::soft;

TEST_CASE("a spinning, moving body has the momenta and energy of its masses", "[measures]") {
  const Model model = box_model(2, 2, 2, {0.2, 0.2, 0.2}, soft(1e5));
  State state = initial_state(model);
  const Vector3d spin(0, 0, 3), drift(1, 0, -2), shift(0, 5, 0);
  Vector3d center = Vector3d::Zero();
  double inertia = 0;  // about z through the center of mass
  const std::vector<double> mass = consistent_masses(model);
  for (std::size_t v = 0; v < mass.size(); ++v) center += mass[v] * model.rest_positions[v] / 8;
  for (std::size_t v = 0; v < mass.size(); ++v) {
    const Vector3d arm = model.rest_positions[v] - center;
    inertia += mass[v] * (arm.x() * arm.x() + arm.y() * arm.y());
    state.displacement[v] = shift;
    state.velocity[v] = drift + spin.cross(arm);
  }
  const Measures measures = measure(model, state);
  const double total = 8;  // 0.008 m^3 of 1000 kg/m^3
  CHECK((measures.momentum - total * drift).norm() < 1e-13);
  CHECK(measures.angular_momentum.z() ==
        Approx(inertia * spin.z() + (center + shift).cross(total * drift).z()).epsilon(1e-13));
  // The box's lumped masses are not symmetric about its center, so only the exact sum is compared.
  CHECK(measures.kinetic == Approx(0.5 * total * drift.squaredNorm() + 0.5 * inertia * 9).epsilon(1e-13));
  CHECK(measures.elastic == 0);
  CHECK(measures.min_det_f == 1);
  CHECK(measures.max_det_f == 1);
  CHECK(measures.inverted == 0);
}

TEST_CASE("a spinning box of quadratic tets has the continuum's moments of inertia", "[measures]") {
  const Vector3d size(0.3, 0.2, 0.1);
  const Model model = test::quadratic(box_model(1, 2, 1, size, soft(1e5)));
  State state = initial_state(model);
  const Vector3d spin(1, -2, 3), drift(1, 0, -2);
  for (std::size_t v = 0; v < state.velocity.size(); ++v)
    state.velocity[v] = drift + spin.cross(model.rest_positions[v] - 0.5 * size);
  const double total = 1000 * size.prod();
  const Vector3d squares = size.cwiseAbs2(),
                 inertia = total / 12 * (Vector3d::Constant(squares.sum()) - squares);  // about its axes
  const Measures measures = measure(model, state);
  CHECK((measures.momentum - total * drift).norm() < 1e-13 * total);
  CHECK((measures.angular_momentum - inertia.cwiseProduct(spin) - (0.5 * size).cross(total * drift)).norm() < 1e-13);
  CHECK(measures.kinetic ==
        Approx(0.5 * total * drift.squaredNorm() + 0.5 * inertia.dot(spin.cwiseAbs2())).epsilon(1e-13));
}

TEST_CASE("inverted tets are counted", "[measures]") {
  const Model model = box_model(1, 1, 1, {1, 1, 1}, soft(1e5));
  State state = initial_state(model);
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    state.displacement[v] = Vector3d(-2.5 * model.rest_positions[v].x(), 0, 0);
  const Measures measures = measure(model, state);
  CHECK(measures.inverted == 6);
  CHECK(measures.min_det_f == Approx(-1.5));
  CHECK(measures.max_det_f == Approx(-1.5));
}

TEST_CASE("exports are in the file's order; tets excluded from the simulation are neutral", "[measures]") {
  Model model = box_model(1, 1, 1, {1, 1, 1}, soft(1e5));
  model.materials.push_back(soft(3e5));
  model.tets = {model.file_mesh.tets[4], model.file_mesh.tets[1]};
  model.tet_source = {4, 1};
  model.tet_material = {1, 0};
  State state = initial_state(model);
  const Matrix3d stretch = Vector3d(1.2, 1, 1).asDiagonal();
  for (std::size_t v = 0; v < state.displacement.size(); ++v) {
    state.displacement[v] = stretch * model.rest_positions[v] - model.rest_positions[v];
    state.velocity[v] = Vector3d(0, static_cast<double>(v), 0);
  }
  const StateFields fields = export_fields(model, state);
  REQUIRE(fields.displacement.size() == 8);
  REQUIRE(fields.green_strain.size() == 6);
  CHECK(test::flat(fields.displacement) == test::flat(state.displacement));
  CHECK(test::flat(fields.velocity) == test::flat(state.velocity));
  for (const std::size_t t : {0, 2, 3, 5}) {
    CHECK(fields.green_strain[t].norm() == 0);
    CHECK(fields.von_mises[t] == 0);
    CHECK(fields.det_f[t] == 1);
  }
  for (const std::size_t t : {1, 4}) {
    CHECK(fields.green_strain[t][0] == Approx(0.22).epsilon(1e-12));
    CHECK(fields.green_strain[t].tail<5>().norm() < 1e-14);
    CHECK(fields.det_f[t] == Approx(1.2).epsilon(1e-12));
  }
  CHECK(fields.von_mises[1] == Approx(von_mises(stretch, soft(1e5))).epsilon(1e-12));
  CHECK(fields.von_mises[4] == Approx(von_mises(stretch, soft(3e5))).epsilon(1e-12));
  const Measures measures = measure(model, state);
  CHECK(measures.max_von_mises == Approx(von_mises(stretch, soft(3e5))).epsilon(1e-12));
  CHECK(measures.max_strain == Approx(0.22).epsilon(1e-12));
}

}  // namespace
}  // namespace fascia::reference
