// Contact in the reference solver against closed forms: weights, the patch test, inclines, stopping distances, a grasp,
// falls.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/contact/contact_surface.h"
#include "sim/grab/build_model.h"
#include "sim/reference/newton.h"
#include "sim/scene/scene.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/support.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using test::box_model;
using test::frames;
using test::soft;
using test::source_dir;

constexpr double kGravity = 9.81;

Tool ground_of(double friction, const Vector3d& normal = {0, 1, 0}) {
  Tool tool;
  tool.name = "ground";
  tool.shape = PlaneShape{{0, 0, 0}, normal};
  tool.friction = friction;
  tool.path.emplace_back();
  return tool;
}

Model cube_on_ground(double size, int cells, const Material& material, double friction) {
  Model model = box_model(cells, cells, cells, {size, size, size}, material);
  model.gravity = {0, -kGravity, 0};
  model.tools = {ground_of(friction)};
  return model;
}

Vector3d mean(const std::vector<Vector3d>& values) {
  Vector3d sum(0, 0, 0);
  for (const Vector3d& v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double lowest(const Model& model, const State& state) {
  double low = 1e9;
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    low = std::min(low, model.rest_positions[v].y() + state.displacement[v].y());
  return low;
}

TEST_CASE("the ground carries the weight of a cube", "[contact]") {
  for (const double young_modulus : {1e5, 1e6}) {
    const Model model = cube_on_ground(0.2, 4, soft(young_modulus, 0.3, 0.05), 0.5);
    NewtonSolver solver(model, frames());
    State state = initial_state(model);
    for (int i = 0; i < 240; ++i) {
      const NewtonReport report = solver.step(state);
      CAPTURE(i, report.iterations, report.relative_residual);
      CHECK(report.converged);
    }
    const ToolLoad load = solver.tool_loads().front();
    CAPTURE(young_modulus, load.force.transpose(), load.points, load.deepest, lowest(model, state));
    CHECK(load.force.y() == Approx(78.48).epsilon(1e-6));
    CHECK(load.force.head<1>().norm() < 1e-6);
    CHECK(load.deepest < 5e-5 * 0.05);
    CHECK(load.points == 25);
  }
}

TEST_CASE("a cube above or on the ground has a static equilibrium without fixed vertices", "[contact]") {
  for (const double height : {0.0, 0.05}) {
    Model model = cube_on_ground(0.2, 4, soft(1e5), 0.5);
    for (Vector3d& x : model.rest_positions) x.y() += height;
    NewtonSolver solver(model, frames());
    State state = initial_state(model);
    const NewtonReport report = solver.solve_static(state);
    const ToolLoad load = solver.tool_loads().front();
    CAPTURE(height, report.iterations, report.relative_residual, load.force.transpose(), load.deepest);
    CHECK(report.converged);
    CHECK(load.force.y() == Approx(78.48).epsilon(1e-8));
    CHECK(load.deepest < 1e-8 * 0.05);
  }
}

// The force of a stiff point is the penalty times a depth of few digits. Weights are carried to as many as that leaves.
TEST_CASE("stiff bodies rest on the ground wherever they start", "[contact]") {
  for (const double size : {0.01, 0.1})
    for (const double young_modulus : {1e4, 1e6, 1e8, 1e9})
      for (const double height : {0.0, 1e-6, 1e-3, -1e-3}) {
        Model model = cube_on_ground(size, 4, soft(young_modulus, 0.3), 0.5);
        for (Vector3d& x : model.rest_positions) x.y() += height;
        NewtonSolver solver(model, frames());
        State state = initial_state(model);
        const NewtonReport report = solver.solve_static(state);
        const ToolLoad load = solver.tool_loads().front();
        const double weight = 1000 * size * size * size * kGravity;
        CAPTURE(size, young_modulus, height, report.iterations, report.relative_residual, load.force.transpose());
        CHECK(report.converged);
        CHECK(report.rests);
        CHECK(report.iterations < 200);
        CHECK((load.force - Vector3d(0, weight, 0)).norm() < 1e-6 * weight);
      }
}

TEST_CASE("what falls beside a tool or slides on it has no static equilibrium", "[contact]") {
  Model beside = cube_on_ground(0.1, 2, soft(2e4), 0.5);
  beside.tools.front().shape = BoxShape{{0.5, 0, 0}, {0.1, 0.1, 0.1}};
  Model slides = cube_on_ground(0.1, 2, soft(2e4), 0.5);
  slides.gravity.x() = 1.2 * 0.5 * kGravity;
  Model rests = slides;
  rests.gravity.x() = 0.95 * 0.5 * kGravity;
  for (const Model* model : {&beside, &slides, &rests}) {
    NewtonSolver solver(*model, frames());
    State state = initial_state(*model);
    const NewtonReport report = solver.solve_static(state);
    CAPTURE(model == &beside, model == &slides, report.iterations, report.relative_residual);
    CHECK(report.converged == (model == &rests));
    CHECK(report.rests == (model == &rests));
  }
}

TEST_CASE("in a static equilibrium friction holds against the pull of a grab", "[contact]") {
  const Model model = cube_on_ground(0.1, 2, soft(1e5), 0.5);
  NewtonSolver solver(model, frames());
  const double pull = 3;  // [N], of 4.9 that friction bears
  const std::uint32_t held = 4;
  // So long that its force hardly depends on where the vertex goes.
  solver.set_springs({{held, Vector3d(1e3 * pull, 0, 0), 1e-3}});
  State state = initial_state(model);
  CHECK(solver.solve_static(state).converged);
  const Vector3d force = solver.tool_loads().front().force;
  CAPTURE(force.transpose());
  CHECK(force.x() == Approx(-pull).epsilon(1e-4));
  CHECK(force.y() == Approx(9.81).epsilon(1e-4));
}

// A slab of 12 x 4 x 6 cm, held from below, into which a sharp tool is pressed by 3 mm without friction: at once,
// points near its edges would leave to the sides, and hold less.
TEST_CASE("a static equilibrium under sharp edges is the one that a motion leads to", "[contact]") {
  const std::vector<ToolShape> shapes = {BoxShape{{0, 0.015, 0}, {0.015, 0.015, 0.015}},
                                         CylinderShape{{0, 0, 0}, {0, 0.03, 0}, 0.015}};
  for (const ToolShape& shape : shapes) {
    Model model =
        box_model(12, 4, 6, {0.12, 0.04, 0.06}, soft(1e4, 0.3), [](const Vector3d& x) { return x.y() < 1e-9; });
    Tool tool;
    tool.name = "tool";
    tool.shape = shape;
    tool.path = {{0, {0.06, 0.0401, 0.03}, {0, 0, 0}}, {0.3, {0.06, 0.037, 0.03}, {0, 0, 0}}};
    model.tools = {tool};
    NewtonSolver solver(model, frames());
    State moved = initial_state(model), state = moved;
    for (int step = 0; step < 30; ++step) solver.step(moved);
    const Vector3d after_motion = solver.tool_loads().front().force;
    const NewtonReport report = solver.solve_static(state);
    const Vector3d force = solver.tool_loads().front().force;
    const double elastic = measure(model, state).elastic, elastic_moved = measure(model, moved).elastic;
    CAPTURE(shape.index(), force.transpose(), after_motion.transpose(), elastic, elastic_moved, report.iterations);
    CHECK(report.converged);
    CHECK((force - after_motion).norm() < 0.03 * after_motion.norm());
    CHECK(elastic == Approx(elastic_moved).epsilon(0.03));
  }
}

// F = A0 E a (1 - a^2) / 2 with a the stretch, for St. Venant-Kirchhoff under uniaxial compression between plates
// without friction. The thin plate ends wholly below where the top of the block was.
TEST_CASE("a block between two plates passes the patch test, however thin the upper one is", "[contact]") {
  const std::vector<ToolShape> plates = {PlaneShape{{0, 0, 0}, {0, -1, 0}},
                                         BoxShape{{0.1, 0.004, 0.1}, {0.15, 0.004, 0.15}}};
  for (const ToolShape& shape : plates)
    for (const double stretch : {0.9, 0.95}) {
      Material material = soft(1e5);
      material.model = MaterialModel::st_venant_kirchhoff;
      Model model = box_model(4, 4, 4, {0.2, 0.2, 0.2}, material);
      Tool top = ground_of(0);
      top.name = "plate";
      top.shape = shape;
      top.path = {{0, {0, 0.2, 0}, {0, 0, 0}}, {1, {0, 0.2 * stretch, 0}, {0, 0, 0}}};
      model.tools = {ground_of(0), top};
      NewtonSolver solver(model, frames());
      State state = initial_state(model);
      const NewtonReport report = solver.solve_static(state);
      const double exact = 0.04 * 1e5 * stretch * (1 - stretch * stretch) / 2;
      const ToolLoad plate = solver.tool_loads()[1], ground = solver.tool_loads()[0];
      double bump = 0;  // of the faces
      for (std::size_t v = 0; v < state.displacement.size(); ++v) {
        const double y = model.rest_positions[v].y();
        bump = std::max(bump, std::abs(state.displacement[v].y() - y * (stretch - 1)));
      }
      CAPTURE(shape.index(), stretch, report.iterations, report.relative_residual, plate.force.transpose(), exact,
              bump);
      CHECK(report.converged);
      CHECK(-plate.force.y() == Approx(exact).epsilon(1e-6));
      CHECK(ground.force.y() == Approx(exact).epsilon(1e-6));
      CHECK(bump < 1e-7 * 0.05);
    }
}

// Two seconds of settling, so that the cube's own wobble has ended.
TEST_CASE("friction holds a cube on an incline below the limit and brakes it above", "[contact]") {
  for (const double share : {0.9, 0.98, 1.02, 1.2}) {
    const double mu = 0.5, slope = std::atan(share * mu), size = 0.1;
    Model model = cube_on_ground(size, 2, soft(1e5, 0.3, 0.05), mu);
    model.gravity = kGravity * Vector3d(std::sin(slope), -std::cos(slope), 0);
    NewtonSolver solver(model, frames());
    State state = initial_state(model);
    for (int i = 0; i < 120; ++i) solver.step(state);
    const Vector3d before = mean(state.displacement), speed = mean(state.velocity);
    for (int i = 0; i < 60; ++i) solver.step(state);
    const double way = (mean(state.displacement) - before).x();
    const double acceleration = (mean(state.velocity) - speed).x();
    const double exact = kGravity * (std::sin(slope) - mu * std::cos(slope));
    CAPTURE(share, way, acceleration, exact);
    if (share < 1) {
      CHECK(std::abs(way) < 1e-6 * size);
    } else {
      CHECK(acceleration == Approx(exact).epsilon(1e-3));
    }
  }
}

// v^2 / (2 mu g) from a speed v, of which implicit Euler, whose steps have the speed of their end, lacks v h / 2.
TEST_CASE("a sliding cube stops", "[contact]") {
  const double mu = 0.5, v = 1;
  Model model = cube_on_ground(0.1, 2, soft(2e5, 0.3, 0.05), mu);
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  for (int i = 0; i < 120; ++i) solver.step(state);
  for (Vector3d& velocity : state.velocity) velocity.x() += v;
  const Vector3d before = mean(state.displacement);
  for (int i = 0; i < 120; ++i) solver.step(state);
  const double way = (mean(state.displacement) - before).x(), h = frames().time_step;
  const double exact = v * v / (2 * mu * kGravity) - v * h / 2;
  CAPTURE(way, exact, mean(state.velocity).x());
  CHECK(way == Approx(exact).epsilon(0.02));
  CHECK(std::abs(mean(state.velocity).x()) < 1e-5);
}

TEST_CASE("a dropped cube lands and never has more energy than at its start", "[contact]") {
  Model model = cube_on_ground(0.1, 2, soft(1e5), 0.5);
  for (Vector3d& x : model.rest_positions) x.y() += 0.02;
  NewtonSolver solver(model, frames());
  State state = initial_state(model);
  const double fall = 1.0 * kGravity * 0.02;  // [J] of its mass, 1 kg
  double highest = -fall;
  for (int i = 0; i < 120; ++i) {
    solver.step(state);
    const Measures m = measure(model, state);
    highest = std::max(highest, m.kinetic + m.elastic + m.gravitational);
  }
  CAPTURE(highest, fall, lowest(model, state));
  CHECK(highest < 1e-9 * fall);
  CHECK(std::abs(lowest(model, state)) < 1e-3 * 0.1);
}

// The step in which this cube tips onto its face has another minimum, on another face.
TEST_CASE("a stiff cube that tips on the ground does not jump onto another face", "[contact]") {
  const Scene scene = read_scene_content(source_dir() / "assets/scenes/tipping.json", R"({
    "fascia_scene": 1,
    "bodies": [{"name": "cube", "mesh": "../meshes/cube.msh",
      "transform": {"scale": 0.4, "rotate_deg": [20, 10, 35], "translate": [0, 0.056, 0]},
      "materials": {"default": {"young_modulus": 3e6, "poisson_ratio": 0.4, "density": 1000, "model": "squared"}}}],
    "ground": {"height": 0, "friction": 0.3}})",
                                         {});
  const Model model = build_model(scene);
  NewtonSolver solver(model, scene.solver);
  State state = initial_state(model);
  for (int i = 0; i < 12; ++i) {
    const Measures before = measure(model, state);
    solver.step(state);
    const Measures after = measure(model, state);
    CAPTURE(i, before.kinetic, before.gravitational, after.kinetic, after.gravitational);
    CHECK(after.kinetic + after.elastic + after.gravitational <
          before.kinetic + before.elastic + before.gravitational + 1e-9);
  }
}

}  // namespace
}  // namespace fascia::reference
