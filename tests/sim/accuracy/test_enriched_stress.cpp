// The stress that linear tets lack, against finer meshes of quadratic ones.
#include "sim/accuracy/enriched_stress.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/recovered_stress.h"
#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

/// A bar of 0.5 x 0.2 x 0.2 m that is held at x = 0, and at its other end with `both`.
Model bar(int cells, double nu, bool both) {
  Material material = soft(2e6, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  Model model = box_model(cells, cells / 2, cells / 2, {0.5, 0.2, 0.2}, material,
                          [&](const Vector3d& x) { return x.x() == 0 || (both && x.x() > 0.5 - 1e-9); });
  model.gravity = {3, -9.81, 1};
  return model;
}

/// With inner vertices displaced at random by up to a fifth of a cell, and those of the surface along it.
void shake(Model& model, double cell) {
  Random random(5);
  for (Vector3d& x : model.rest_positions)
    for (int axis = 0; axis < 3; ++axis) {
      const double side = axis == 0 ? 0.5 : 0.2, way = 0.2 * cell * random();
      if (x[axis] > 1e-9 && x[axis] < side - 1e-9) x[axis] += way;
    }
}

State held_up(const Model& model) {
  State state = initial_state(model);
  REQUIRE(reference::NewtonSolver(model, {}).solve_static(state).converged);
  return state;
}

}  // namespace

// Between two supports the stresses that 1 % of the volume exceeds are those of their edges, which no tet resolves.
TEST_CASE("the error of linear tets is known within a tenth, and that of the stress at one support within a fifth") {
  const auto [nu, both] = GENERATE(std::pair(0.3, false), std::pair(0.3, true), std::pair(0.47, false));
  const Model fine = quadratic(bar(12, nu, both));
  const State finest = held_up(fine);
  const double energy = reference::measure(fine, finest).elastic, peak = peak_of(nodal_stress(fine, finest), fine).p99;
  Model model = bar(10, nu, both);
  shake(model, 0.04);
  const State state = held_up(model);
  const MeshError estimate = estimate_mesh_error(model, state);
  const double error = std::abs(reference::measure(model, state).elastic / energy - 1),
               peak_error = std::abs(estimate.peak_of_tets / peak - 1);
  CAPTURE(nu, both, error, estimate.displacement, peak_error, estimate.peak_stress);
  CHECK(estimate.displacement == Approx(error).epsilon(0.1));
  if (!both) CHECK(estimate.peak == Approx(peak).epsilon(0.2 * peak_error + 0.02));
}

TEST_CASE("nothing is missing where pressure acts on all of the surface of a box") {
  const Model model = box_model(4, 4, 4, {0.2, 0.2, 0.2}, soft(1e5, 0.3));
  State state = initial_state(model);
  const double stretch = 0.98;
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    state.displacement[v] = (stretch - 1) * model.rest_positions[v];
  const EnrichedStress enriched(model, state);
  double most = 0, own = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    Vector3d center = Vector3d::Zero();
    for (const std::uint32_t v : model.tets[t]) center += 0.25 * model.rest_positions[v];
    if ((center - Vector3d::Constant(0.1)).cwiseAbs().maxCoeff() > 0.05) continue;  // edges have two tractions
    own = stresses_of(model, state, t, {Vector4d::Constant(0.25)}).front().stress.norm();
    most = std::max(most, enriched.at(t, Vector4d::Constant(0.25)).norm());
  }
  CAPTURE(most, own);
  CHECK(most < 0.03 * own);
}

TEST_CASE("a search for what is missing that is asked to stop has not converged") {
  const Model model = bar(4, 0.3, false);
  std::stop_source stop;
  stop.request_stop();
  const EnrichedStress enriched(model, held_up(model), stop.get_token());
  CHECK_FALSE(enriched.converged());
  CHECK(EnrichedStress(model, held_up(model)).converged());
}
