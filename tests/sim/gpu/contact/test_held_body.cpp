// Bodies that tools press: one that two tools lift and hold by friction comes to rest between them, with all
// integrators, and one that becomes softer stays where it is.
// Covers: contact_term, contact_passes
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kBody = 0.05;  // [m]

Tool gripping_box(const std::string& name, double side, double friction, double depth) {
  const double apart = 0.5 * kBody + 0.012, pressed = 0.5 * kBody + 0.01 - depth;
  return test::tool(name, BoxShape{{0, 0, 0}, {0.01, 0.02, 0.02}, 0.001}, friction,
                    {{0, {side * apart, 0.025, 0}, {0, 0, 0}},
                     {0.2, {side * pressed, 0.025, 0}, {0, 0, 0}},
                     {0.4, {side * pressed, 0.025, 0}, {0, 0, 0}},
                     {1.0, {side * pressed, 0.085, 0}, {0, 0, 0}}});
}

void lift_and_hold(Integrator integrator, double friction) {
  const Material tissue = test::squared(4e4);
  Model model = test::cube(kBody, 4, tissue);
  for (Vector3d& x : model.rest_positions) x -= Vector3d(0.5 * kBody, 0, 0.5 * kBody);
  model.tools = {test::tool("table", PlaneShape{{0, 0, 0}, {0, 1, 0}}, 0.3), gripping_box("left", -1, friction, 0.002),
                 gripping_box("right", 1, friction, 0.002)};
  test::Gpu gpu;
  SolverSettings settings = test::two_level();
  settings.integrator = integrator;
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  double highest = 0, kinetic = 0, elastic = 0;
  Vector3d force(0, 0, 0);
  for (int i = 0; i < 270; ++i) {
    solver.step();
    if (i < 240) continue;
    const reference::Measures measures = reference::measure(model, solver.download());
    kinetic = std::max(kinetic, measures.kinetic);
    elastic = measures.elastic;
  }
  solver.request_diagnostics();
  const Diagnostics diagnostics = *solver.take_diagnostics(true);
  for (const ToolLoad& load : diagnostics.tool_loads) force += load.force;
  for (const Vector3d& u : solver.download().displacement) highest = std::max(highest, u.y());
  const double weight = 9.81 * 1000 * kBody * kBody * kBody;
  CAPTURE(name_of(integrator), friction, highest, kinetic / elastic, force.transpose() / weight);
  CHECK(highest > 0.05);  // lifted by 6 cm
  CHECK(kinetic < 1e-6 * elastic);
  CHECK((force - Vector3d(0, weight, 0)).norm() < 2e-3 * weight);
}

TEST_CASE("a body that two tools lift is at rest between them", "[gpu][contact]") {
  for (const Integrator integrator : {Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2})
    for (const double friction : {0.6, 1.2}) lift_and_hold(integrator, friction);
}

// The kinetic energy of the first step after a pressed body became softer by `factor`, over the elastic energy that was
// left in it.
double thrown_off(const Model& pressed, double factor) {
  Model model = pressed;
  test::Gpu gpu;
  SolverSettings settings = test::two_level();
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  for (int i = 0; i < 60; ++i) solver.step();
  model.materials.back().young_modulus *= factor;
  const double elastic = reference::measure(model, solver.download()).elastic;
  solver.materials_changed();
  solver.step();
  const double kinetic = reference::measure(model, solver.download()).kinetic;
  REQUIRE(elastic > 0);
  return kinetic / elastic;
}

TEST_CASE("tissue that becomes softer is not thrown off what presses it", "[gpu][contact]") {
  const Tool table = test::tool("table", PlaneShape{{0, 0, 0}, {0, 1, 0}}, 0.5);
  Model single = test::cube(kBody, 4, test::squared(1e6));
  single.gravity.setZero();
  single.tools = {table, test::tool("ball", SphereShape{{0, 0, 0}, 0.02}, 0.5,
                                    {{0, {0.025, 0.071, 0.025}, {0, 0, 0}}, {0.5, {0.028, 0.063, 0.025}, {0, 0, 0}}})};
  Model pair = test::beside(test::cube(kBody, 4, test::squared(1e6)),
                            test::moved(test::cube(kBody, 3, test::squared(1e6)), {0, kBody + 0.001, 0}), "upper");
  pair.gravity.setZero();
  pair.contact.friction = 0.5;
  pair.tools = {table, test::tool("plate", BoxShape{{0, 0, 0}, {0.05, 0.01, 0.05}}, 0.5,
                                  {{0, {0.025, 0.112, 0.025}, {0, 0, 0}}, {0.5, {0.025, 0.106, 0.025}, {0, 0, 0}}})};
  for (const double factor : {0.3, 0.01, 1e-3}) {
    const double one = thrown_off(single, factor), two = thrown_off(pair, factor);
    CAPTURE(factor, one, two);
    CHECK(one < 0.01);
    CHECK(two < 0.01);
  }
}

}  // namespace
}  // namespace fascia
