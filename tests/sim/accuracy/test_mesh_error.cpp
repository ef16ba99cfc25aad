#include "sim/accuracy/mesh_error.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/accuracy/recovered_stress.h"
#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// The beam of 1 x 0.25 x 0.25 m that is held at x = 0 and bends under its weight, with `cells` along x.
Model beam(int cells, double nu, bool ten_nodes) {
  Material material = soft(1e6, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  Model model =
      box_model(cells, cells / 4, cells / 4, {1, 0.25, 0.25}, material, [](const Vector3d& x) { return x.x() == 0; });
  if (ten_nodes) model = quadratic(model);
  model.gravity = {0, -9.81, 0};
  return model;
}

State equilibrium(const Model& model) {
  State state = initial_state(model);
  REQUIRE(reference::NewtonSolver(model, {}).solve_static(state).converged);
  return state;
}

double tip(const Model& model, const State& state) {
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    if ((model.rest_positions[v] - Vector3d(1, 0.125, 0.125)).norm() < 1e-9) return state.displacement[v].y();
  FAIL("no vertex at the tip");
  return 0;
}

}  // namespace

TEST_CASE("a body at rest and one in uniform strain have no error of the mesh") {
  const bool ten_nodes = GENERATE(false, true);
  const auto at_surface = [](const Vector3d& x) { return x.minCoeff() < 1e-9 || x.maxCoeff() > 0.2 - 1e-9; };
  const Model box = box_model(3, 3, 3, {0.2, 0.2, 0.2}, soft(1e5, 0.45), at_surface),
              model = ten_nodes ? quadratic(box) : box;
  State state = initial_state(model);
  CHECK(estimate_mesh_error(model, state).displacement == 0);
  Random random(3);
  const Matrix3d f = random.rotation() * Vector3d(1.2, 0.9, 0.95).asDiagonal();
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    state.displacement[v] = f * model.rest_positions[v] - model.rest_positions[v];
  const MeshError error = estimate_mesh_error(model, state);
  CAPTURE(ten_nodes, error.displacement, error.peak_stress);
  CHECK(error.displacement < 1e-12);
  CHECK(error.peak_stress < 1e-9);
  CHECK(*std::max_element(error.tets.begin(), error.tets.end()) < 1e-6);
}

TEST_CASE("the error of a body that nothing holds does not change when it is turned as a whole") {
  Model model = beam(8, 0.3, GENERATE(false, true));
  State state = equilibrium(model);
  model.fixed.clear();  // what held it is a load from here on
  const MeshError before = estimate_mesh_error(model, state);
  const Matrix3d turn = Random(4).rotation();
  for (std::size_t v = 0; v < state.displacement.size(); ++v) {
    const Vector3d& x = model.rest_positions[v];
    state.displacement[v] = turn * (x + state.displacement[v]) - x;
  }
  const MeshError after = estimate_mesh_error(model, state);
  CAPTURE(before.displacement);
  CHECK(before.displacement > 0);
  CHECK(after.displacement == Approx(before.displacement).epsilon(1e-6));
  CHECK(after.peak == Approx(before.peak).epsilon(1e-6));
}

TEST_CASE("the error of a body that falls does not depend on how far it fell") {
  Model model = beam(8, 0.3, GENERATE(false, true));
  State state = equilibrium(model);
  model.fixed.clear();
  const double before = estimate_mesh_error(model, state).displacement;
  for (Vector3d& u : state.displacement) u.y() -= 20;
  const double after = estimate_mesh_error(model, state).displacement;
  CAPTURE(before);
  CHECK(after == Approx(before).epsilon(1e-6));
}

// The continuum's deflection: test_newton_quadratic.cpp.
TEST_CASE("the estimated error of a bent beam is 0.7 to 1.5 of the error against the continuum") {
  struct Row {
    int cells;
    double nu, truth;
    bool ten_nodes;
  };
  const Row row = GENERATE(Row{8, 0.3, -0.23729, false}, Row{32, 0.3, -0.23729, false}, Row{16, 0.3, -0.23729, false},
                           Row{24, 0.3, -0.23729, false}, Row{8, 0.45, -0.23267, false}, Row{16, 0.45, -0.23267, false},
                           Row{24, 0.45, -0.23267, false}, Row{16, 0.49, -0.23066, false},
                           Row{24, 0.49, -0.23066, false}, Row{8, 0.3, -0.23729, true});
  const Model model = beam(row.cells, row.nu, row.ten_nodes);
  const State state = equilibrium(model);
  const double error = std::abs(tip(model, state) / row.truth - 1);
  const MeshError estimate = estimate_mesh_error(model, state);
  CAPTURE(row.cells, row.nu, row.ten_nodes, error, estimate.displacement, estimate.displacement / error);
  CHECK(estimate.displacement > 0.7 * error);
  CHECK(estimate.displacement < 1.5 * error);
}

TEST_CASE("the tets with the largest errors are at the support, and refinement lowers all of them") {
  const bool ten_nodes = GENERATE(false, true);
  const Model coarse = beam(8, 0.3, ten_nodes), fine = beam(16, 0.3, ten_nodes);
  const auto largest_at = [](const Model& model, const MeshError& error) {
    const auto t = std::max_element(error.tets.begin(), error.tets.end()) - error.tets.begin();
    Vector3d center = Vector3d::Zero();
    for (const std::uint32_t v : model.tets[static_cast<std::size_t>(t)]) center += 0.25 * model.rest_positions[v];
    return center;
  };
  const MeshError at_coarse = estimate_mesh_error(coarse, equilibrium(coarse)),
                  at_fine = estimate_mesh_error(fine, equilibrium(fine));
  CAPTURE(ten_nodes, at_coarse.displacement, at_fine.displacement, largest_at(coarse, at_coarse).transpose());
  CHECK(largest_at(coarse, at_coarse).x() < 0.2);
  CHECK(largest_at(fine, at_fine).x() < 0.2);
  CHECK(at_fine.displacement < 0.6 * at_coarse.displacement);
}

TEST_CASE("at a vertex the errors of the tets around it are weighted by their volumes") {
  const bool ten_nodes = GENERATE(false, true);
  const Model model = beam(8, 0.3, ten_nodes);
  const MeshError error = estimate_mesh_error(model, equilibrium(model));
  const std::vector<float> mean = at_vertices(model, error);
  REQUIRE(mean.size() == model.rest_positions.size());
  for (const std::uint32_t v : {0u, 17u, static_cast<std::uint32_t>(mean.size() - 1)}) {
    double sum = 0, volume = 0;
    for (std::size_t t = 0; t < model.tets.size(); ++t) {
      const ElementVertices element = model.element(t);
      if (std::find(element.begin(), element.end(), v) == element.end()) continue;
      sum += volume_of(model, t) * static_cast<double>(error.tets[t]);
      volume += volume_of(model, t);
    }
    CAPTURE(ten_nodes, v, sum, volume);
    CHECK(static_cast<double>(mean[v]) == Approx(sum / volume).epsilon(1e-6));
  }
}

TEST_CASE("an estimate that is asked to stop ends with zeros") {
  const Model model = beam(8, 0.3, false);
  std::stop_source stop;
  stop.request_stop();
  const MeshError error = estimate_mesh_error(model, equilibrium(model), stop.get_token());
  CHECK(error.displacement == 0);
  CHECK(error.tets == std::vector<float>(model.tets.size(), 0));
}
