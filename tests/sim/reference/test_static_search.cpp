// Falls of a static solve: bodies far above tissue and thin plates come to rest on them, and held tissue that sags
// meets what is below it.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sim/contact/tissue/penetration.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::beside;
using test::box_model;
using test::frames;
using test::moved;
using test::soft;

constexpr double kSize = 0.04;                                   // of the cubes [m]
constexpr double kWeight = 1000 * kSize * kSize * kSize * 9.81;  // [N]
const Matrix3d kTilt(Eigen::AngleAxisd(0.5, Vector3d(2, 1, -1).normalized()));

// Its lowest vertex is `height` above y = 0, and its middle near the y axis.
Model cube_above(double height, double young_modulus, const Matrix3d& turn) {
  Model body = box_model(2, 2, 2, {kSize, kSize, kSize}, soft(young_modulus));
  double low = 1;
  for (Vector3d& x : body.rest_positions) {
    x = turn * (x - Vector3d::Constant(kSize / 2)) + Vector3d(0.003, 0, -0.002);
    low = std::min(low, x.y());
  }
  return moved(std::move(body), {0, height - low, 0});
}

// That stays where it is.
Tool still(const std::string& name, const ToolShape& shape) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.friction = 0.5;
  tool.path.emplace_back();
  return tool;
}

double lowest(const Model& model, const State& state, std::uint32_t first_vertex) {
  double low = 1e9;
  for (std::size_t v = first_vertex; v < state.displacement.size(); ++v)
    low = std::min(low, model.rest_positions[v].y() + state.displacement[v].y());
  return low;
}

TEST_CASE("a body that falls by a multiple of its size rests on the tissue below", "[static]") {
  for (const double young_modulus : {2e4, 1e6})
    for (const double sizes : {0.1, 1.0, 3.0})
      for (const Matrix3d& turn : {Matrix3d(Matrix3d::Identity()), kTilt}) {
        const Model slab = moved(
            box_model(6, 2, 6, {0.12, 0.03, 0.12}, soft(young_modulus), [](const Vector3d& x) { return x.y() < 1e-9; }),
            {-0.06, -0.03, -0.06});
        Model model = beside(slab, cube_above(sizes * kSize, young_modulus, turn), "cube");
        model.gravity = {0, -9.81, 0};
        model.contact.friction = 0.5;
        NewtonSolver solver(model, frames());
        State state = initial_state(model);
        const NewtonReport report = solver.solve_static(state);
        CAPTURE(young_modulus, sizes, turn == kTilt, report.iterations, report.relative_residual, report.goes_through);
        CHECK(report.converged);
        REQUIRE(solver.pair_loads().size() == 1);
        CHECK((solver.pair_loads()[0].force - Vector3d(0, kWeight, 0)).norm() < 1e-6 * kWeight);
        CHECK(penetrating_triangles(model, state.displacement) == 0);
        CHECK(lowest(model, state, model.bodies[1].vertex_begin) > -0.1 * kSize);
      }
}

TEST_CASE("a body that falls by a multiple of its size rests on a thin plate", "[static]") {
  for (const double sizes : {0.1, 1.5, 3.0})
    for (const Matrix3d& turn : {Matrix3d(Matrix3d::Identity()), kTilt}) {
      Model model = cube_above(sizes * kSize, 1e5, turn);
      model.tools = {still("plate", BoxShape{{0, -0.0005, 0}, {0.1, 0.0005, 0.1}})};
      model.gravity = {0, -9.81, 0};
      NewtonSolver solver(model, frames());
      State state = initial_state(model);
      const NewtonReport report = solver.solve_static(state);
      CAPTURE(sizes, turn == kTilt, report.iterations, report.relative_residual, report.goes_through);
      CHECK(report.converged);
      CHECK((solver.tool_loads()[0].force - Vector3d(0, kWeight, 0)).norm() < 1e-6 * kWeight);
      CHECK(lowest(model, state, 0) > -1e-6);
    }
}

// Held at one end, 2 cm above a slab: without contact its other end hangs 12 cm lower.
TEST_CASE("held tissue that sags comes to lie on the tissue below", "[static]") {
  const Model slab = moved(
      box_model(6, 2, 4, {0.12, 0.02, 0.08}, soft(1e5), [](const Vector3d& x) { return x.y() < 1e-9; }), {0, -0.02, 0});
  Model beam = moved(box_model(12, 2, 3, {0.18, 0.02, 0.04}, soft(1e5), [](const Vector3d& x) { return x.x() < 1e-9; }),
                     {-0.08, 0.02, 0.021});
  Model model = beside(slab, beam, "beam");
  model.gravity = {0, -9.81, 0};
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state);
  CAPTURE(report.iterations, report.relative_residual, report.goes_through);
  CHECK(report.converged);
  REQUIRE(solver.pair_loads().size() == 1);
  CHECK(solver.pair_loads()[0].force.y() > 0.1);
  CHECK(penetrating_triangles(model, state.displacement) == 0);
  CHECK(lowest(model, state, model.bodies[1].vertex_begin) > -0.005);
}

// A bar that a script leads through a wall of tissue, held from below and above: it either pushes the wall along, or
// the solve says that it goes through.
TEST_CASE("what a script leads through tissue is no equilibrium beyond it", "[static]") {
  const auto held = [](const Vector3d& x) { return x.y() < 1e-9 || x.y() > 0.08 - 1e-9; };
  const Model wall = moved(box_model(1, 4, 4, {0.01, 0.08, 0.08}, soft(1e4), held), {0.03, 0, 0});
  const Model bar = moved(box_model(1, 1, 1, {0.02, 0.02, 0.02}, soft(1e5)), {0, 0.031, 0.033});
  Model model = beside(wall, bar, "bar");
  Motion motion;
  motion.duration = 1;
  motion.translate = {0.1, 0, 0};
  const BodyPart& moves = model.bodies[1];
  for (std::uint32_t v = moves.vertex_begin; v < moves.vertex_begin + moves.vertex_count; ++v)
    motion.vertices.push_back(v);
  model.motions = {motion};
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state);
  double farthest = 0;  // of the wall
  for (std::uint32_t v = 0; v < moves.vertex_begin; ++v)
    farthest = std::max(farthest, model.rest_positions[v].x() + state.displacement[v].x());
  CAPTURE(report.iterations, report.goes_through, farthest);
  CHECK((!report.converged || farthest > 0.12));
  CHECK((report.goes_through || penetrating_triangles(model, state.displacement) == 0));
}

// A cube that falls onto the ground, and a scripted plate of tissue that comes down on it or stays beside it.
TEST_CASE("a script moves its tissue while another body falls", "[static]") {
  const bool pushes = GENERATE(false, true);
  const Model plate =
      moved(box_model(4, 1, 4, {0.08, 0.02, 0.08}, soft(1e6)), {pushes ? -0.04 : 0.1, kSize + 0.01, -0.04});
  Model model = beside(plate, cube_above(0.001, 2e4, Matrix3d::Identity()), "cube");
  Motion motion;
  motion.duration = 1;
  motion.translate = {0, -0.014, 0};
  for (std::uint32_t v = 0; v < model.bodies[1].vertex_begin; ++v)
    if (plate.rest_positions[v].y() > kSize + 0.03 - 1e-9) motion.vertices.push_back(v);
  model.motions = {motion};
  model.tools = {still("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}})};
  model.gravity = {0, -9.81, 0};
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state);
  const double force = solver.tool_loads()[0].force.y(), way = state.displacement[motion.vertices[0]].y();
  CAPTURE(pushes, report.iterations, report.goes_through, force / kWeight, way);
  CHECK(report.converged);
  CHECK(way == Approx(-0.014));
  if (pushes)
    CHECK(force > 2 * kWeight);  // it is squeezed by 4 mm of 40, 20 kPa
  else
    CHECK(force == Approx(kWeight).epsilon(1e-6));
  CHECK(penetrating_triangles(model, state.displacement) == 0);
}

// That goes from one place to another within a second.
Tool raised(const std::string& name, const ToolShape& shape, const Vector3d& from, const Vector3d& to) {
  Tool tool = still(name, shape);
  tool.path = {{0, from, {0, 0, 0}, 0}, {1, to, {0, 0, 0}, 0}};
  return tool;
}

// From below to beyond where it began, so that nothing at the end tells that it has been below.
TEST_CASE("a tool that is raised takes what is above it along", "[static]") {
  const auto held = [](const Vector3d& x) { return x.x() < 1e-9 || x.x() > 0.2 - 1e-9; };
  Model model = moved(box_model(8, 1, 3, {0.2, 0.02, 0.08}, soft(2e4), held), {-0.1, -0.01, -0.04});
  SECTION("tissue that is held at both ends") {
    model.tools = {raised("ball", SphereShape{{0, 0, 0}, 0.03}, {0, -0.15, 0}, {0, 0.03, 0})};
  }
  SECTION("a free body on the ground") {
    model = cube_above(0, 2e4, Matrix3d::Identity());
    model.tools = {raised("plate", BoxShape{{0, 0, 0}, {0.05, 0.005, 0.05}}, {0, -0.02, 0}, {0, 0.1, 0}),
                   still("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}})};
  }
  model.gravity = {0, -9.81, 0};
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state);
  const double force = solver.tool_loads()[0].force.y();
  CAPTURE(report.iterations, report.relative_residual, report.goes_through, force);
  CHECK(report.converged);
  CHECK(state.time == 1);
  double highest = -1;
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    highest = std::max(highest, model.rest_positions[v].y() + state.displacement[v].y());
  CHECK(highest > (model.tools.size() == 1 ? 0.06 : 0.105));  // above the tool
  if (model.tools.size() == 1)
    CHECK(force > 1000 * 0.2 * 0.02 * 0.08 * 9.81);  // more than its weight: it is stretched
  else
    CHECK((solver.tool_loads()[0].force - Vector3d(0, kWeight, 0)).norm() < 1e-6 * kWeight);
}

// A ball of 3 cm that ends far beyond a thin sheet that is held all around cannot be where the sheet would let it.
TEST_CASE("a tool that would end beyond held tissue is no equilibrium", "[static]") {
  const auto rim = [](const Vector3d& x) { return std::min({x.x(), 0.08 - x.x(), x.z(), 0.08 - x.z()}) < 1e-9; };
  Model model = moved(box_model(4, 1, 4, {0.08, 0.005, 0.08}, soft(1e5), rim), {-0.04, 0, -0.04});
  model.tools = {raised("ball", SphereShape{{0, 0, 0}, 0.03}, {0, -0.05, 0}, {0, 1, 0})};
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const NewtonReport report = solver.solve_static(state);
  const double force = solver.tool_loads()[0].force.y();
  CAPTURE(report.iterations, report.converged, report.goes_through, force, state.time);
  CHECK((!report.converged || force > 1));
}

}  // namespace
}  // namespace fascia::reference
