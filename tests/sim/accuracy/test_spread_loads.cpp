// Forces at vertices as tractions on faces, and the estimates of bodies that are pulled at vertices, against the same
// tractions on finer meshes.
#include "sim/accuracy/spread_loads.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numeric>

#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/refined_model.h"
#include "tests/sim/accuracy/error_against.h"
#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

using Forces = std::vector<Vector3d>;
constexpr double kLength = 0.4;  // [m] of a bar that is 0.2 m wide and high

/// Held at x = 0, with inner vertices displaced at random.
Model pulled_bar(bool linear, double nu) {
  Material material = soft(1e6, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  TetMesh mesh = make_box(4, 2, 2, {kLength, 0.2, 0.2});
  Random random(7);
  for (Vector3d& x : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) {
      const double way = 0.02 * random();
      if (x[axis] > 1e-9 && x[axis] < (axis == 0 ? kLength : 0.2) - 1e-9) x[axis] += way;
    }
  Model model = make_model(mesh, material, [](const Vector3d& x) { return x.x() < 1e-9; });
  model.gravity.setZero();
  return linear ? model : quadratic(model);
}

Middles middles_in(const Model& model) {
  TetMesh mesh;
  mesh.positions = model.rest_positions;
  mesh.tets = model.tets;
  mesh.mid_edges = model.mid_edges;
  return middles_of(mid_edges_of(mesh));
}

std::vector<FaceLoad> on_faces(const Model& quadratic_model, const Forces& forces, bool linear = false) {
  std::vector<std::uint32_t> tets(quadratic_model.tets.size());
  std::iota(tets.begin(), tets.end(), 0u);
  return spread_on_faces(quadratic_model, tets, middles_in(quadratic_model), quadratic_model.held(), forces, linear);
}

Forces sum_of(const std::vector<FaceLoad>& loads, const Model& model) {
  Forces forces(model.rest_positions.size(), Vector3d::Zero());
  for (const FaceLoad& load : loads) {
    const auto of_face = forces_of(load);
    for (std::size_t i = 0; i < 6; ++i) forces[load.vertices[i]] += of_face[i];
  }
  return forces;
}

/// An even traction on the end of the bar.
std::vector<FaceLoad> even_at_the_end(const Model& model, const Vector3d& traction) {
  std::vector<FaceLoad> loads = on_faces(model, Forces(model.rest_positions.size(), Vector3d::Zero()));
  for (FaceLoad& load : loads)
    if (std::all_of(load.vertices.begin(), load.vertices.end(),
                    [&](std::uint32_t v) { return model.rest_positions[v].x() > kLength - 1e-9; }))
      load.traction.fill(traction);
  return loads;
}

/// What functions L_a have of forces on quadratic functions.
Forces on_corners(Forces forces, const Middles& middles) {
  for (const auto& [ends, middle] : middles) {
    for (const std::uint32_t v : ends) forces[v] += 0.5 * forces[middle];
    forces[middle].setZero();
  }
  return forces;
}

State in_balance(const Model& model, const Forces& forces) {
  constexpr double kSoft = 1e-3;  // [N/m], so that the springs hardly depend on the shape
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (!forces[v].isZero(0)) springs.push_back({v, forces[v] / kSoft, kSoft});
  reference::NewtonSolver solver(model, {});
  solver.set_springs(springs);
  State state = initial_state(model);
  REQUIRE(solver.solve_static(state).converged);
  return state;
}

double work_of(const Forces& forces, const State& state) {
  double work = 0;
  for (std::size_t v = 0; v < state.displacement.size(); ++v) work += forces[v].dot(state.displacement[v]);
  return work;
}

}  // namespace

TEST_CASE("tractions do the work of the forces at free vertices of the surface") {
  const bool linear = GENERATE(false, true);
  const Model model = pulled_bar(false, 0.3);
  const Middles middles = middles_in(model);
  const std::vector<char> held = model.held();
  Random random(3);
  Forces forces(model.rest_positions.size(), Vector3d::Zero());
  const auto at_surface = on_surface({kLength, 0.2, 0.2});
  for (std::size_t v = 0; v < forces.size(); ++v)
    if (at_surface(model.rest_positions[v])) forces[v] = Vector3d(random(), random(), random());
  if (linear) forces = on_corners(forces, middles);
  Forces found = sum_of(on_faces(model, forces, linear), model);
  if (linear) found = on_corners(found, middles);
  for (std::size_t v = 0; v < forces.size(); ++v)
    if (!held[v]) CHECK((found[v] - forces[v]).norm() < 1e-12);
}

TEST_CASE("an even traction on one side is found, and hardly goes round the edges") {
  const bool linear = GENERATE(false, true);
  const Model model = pulled_bar(false, 0.3);
  const Vector3d traction(100, 200, -50);
  const std::vector<FaceLoad> expected = even_at_the_end(model, traction);
  Forces forces = sum_of(expected, model);
  if (linear) forces = on_corners(forces, middles_in(model));
  const std::vector<FaceLoad> found = on_faces(model, forces, linear);
  double difference = 0, size = 0;
  for (std::size_t f = 0; f < found.size(); ++f)
    for (std::size_t i = 0; i < 6; ++i) {
      difference += found[f].area * (found[f].traction[i] - expected[f].traction[i]).squaredNorm();
      size += expected[f].area * expected[f].traction[i].squaredNorm();
    }
  CAPTURE(linear, std::sqrt(difference / size));
  CHECK(std::sqrt(difference / size) < 0.05);  // a hundredth of each edge vertex' force, for each face beside the end
}

TEST_CASE("finer faces have the same tractions: force, torque, and the work on the coarse mesh's motions") {
  const Model model = pulled_bar(false, 0.3);
  Forces forces(model.rest_positions.size(), Vector3d::Zero());
  Random random(4);
  const auto at_surface = on_surface({kLength, 0.2, 0.2});
  for (std::size_t v = 0; v < forces.size(); ++v)
    if (at_surface(model.rest_positions[v])) forces[v] = Vector3d(random(), random(), random());
  State moved = initial_state(model);
  for (Vector3d& u : moved.displacement) u = 0.01 * Vector3d(random(), random(), random());
  const RefinedModel finer = refined(model, moved, ElementOrder::quadratic);
  const std::vector<FaceLoad> loads = on_faces(model, forces);
  const Forces coarse = sum_of(loads, model),
               fine = sum_of(on_finer_faces(loads, finer.model, middles_of(finer.edges)), finer.model);
  CHECK(work_of(fine, finer.state) == Approx(work_of(coarse, moved)).epsilon(1e-10));
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
  for (std::size_t v = 0; v < fine.size(); ++v) {
    force += fine[v];
    torque += finer.model.rest_positions[v].cross(fine[v]);
  }
  for (std::size_t v = 0; v < coarse.size(); ++v) {
    force -= coarse[v];
    torque -= model.rest_positions[v].cross(coarse[v]);
  }
  CHECK(force.norm() < 1e-12);
  CHECK(torque.norm() < 1e-12);
}

TEST_CASE("the error of a body that is pulled at vertices is the difference to a finer mesh under the same tractions") {
  struct Pull {
    std::string name;
    std::function<bool(const Vector3d&)> at;  // corners, each with the same force; none: an even traction at the end
  };
  const auto [name, at] = GENERATE(
      Pull{"even", {}}, Pull{"vertex", [](const Vector3d& x) { return (x - Vector3d(0.3, 0.2, 0.1)).norm() < 0.03; }},
      Pull{"corner", [](const Vector3d& x) { return (x - Vector3d(kLength, 0.2, 0.2)).norm() < 0.01; }},
      Pull{"hand",
           [](const Vector3d& x) { return x.y() > 0.2 - 1e-9 && (x - Vector3d(0.3, 0.2, 0.1)).norm() < 0.12; }});
  const auto [linear, nu] = GENERATE(std::pair(false, 0.3), std::pair(true, 0.3), std::pair(false, 0.47));
  const Vector3d force(0.01, 0.02, 0.005);
  const Model ten = pulled_bar(false, nu), model = pulled_bar(linear, nu);
  std::vector<FaceLoad> loads;
  Forces forces(ten.rest_positions.size(), Vector3d::Zero());
  if (at) {
    for (const Tet& tet : ten.tets)
      for (const std::uint32_t v : tet)
        if (at(ten.rest_positions[v])) forces[v] = force;
    loads = on_faces(ten, forces, linear);
  } else {
    loads = even_at_the_end(ten, force / 0.04);
    forces = sum_of(loads, ten);
    if (linear) forces = on_corners(forces, middles_in(ten));
  }
  const State state = in_balance(model, forces);
  RefinedModel finer = refined(ten, initial_state(ten), ElementOrder::quadratic);
  finer.model.initial_velocity.assign(finer.model.rest_positions.size(), Vector3d::Zero());
  finer.model.gravity.setZero();
  const Forces fine = sum_of(on_finer_faces(loads, finer.model, middles_of(finer.edges)), finer.model);
  const double error = error_against(model, state, in_balance(finer.model, fine));
  const MeshError estimate = estimate_mesh_error(model, state);
  CAPTURE(name, linear, nu, error, estimate.displacement);
  CHECK(estimate.displacement == Approx(error).epsilon(linear ? 0.1 : 0.02));
}
