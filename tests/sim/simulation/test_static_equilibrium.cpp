#include "sim/simulation/static_equilibrium.h"

#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "base/error.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;

namespace {

// A cube of 10 cm and 1 kg at the origin, on the ground if it has one, by the reference solver.
struct FreeCube {
  test::TemporaryFolder folder;
  Scene scene;
  FreeCube() {
    write_mesh(folder / "cube.msh", make_box(3, 3, 3, {0.1, 0.1, 0.1}));
    scene.file = "cube.json";
    Body body;
    body.name = "cube";
    body.mesh = (folder / "cube.msh").string();
    body.material.young_modulus = 1e5;
    scene.bodies.push_back(body);
    scene.tools.ground = Ground{0, 0.5};
  }
  std::string error() const {
    Simulation simulation(scene, nullptr, true);
    try {
      require_equilibrium(simulation, simulation.solve_static());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

}  // namespace

TEST_CASE("after a static solve by the reference solver its forces of contact are read out", "[static]") {
  for (const double height : {0.0, 1e-6, -1e-3, 1e-3}) {
    FreeCube cube;
    cube.scene.tools.ground->height = height;
    Simulation simulation(cube.scene, nullptr, true);
    const StaticReport report = simulation.solve_static();
    CAPTURE(height, describe(report));
    CHECK(report.converged);
    CHECK(simulation.newton_tool_loads().at(0).force.y() == Approx(9.81).epsilon(1e-8));
    Eigen::Vector3d sum(0, 0, 0);
    for (const Eigen::Vector3d& force : simulation.contact_forces()) sum += force;
    CHECK(sum.y() == Approx(9.81).epsilon(1e-8));
  }
}

// What pictures, exports and the step after show is the tool that presses, not where its path begins.
TEST_CASE("after a static solve, time and tools are at the end of their paths", "[static]") {
  FreeCube cube;
  Instrument plate;
  plate.name = "plate";
  plate.shape = ToolShape(BoxShape{{0, 0, 0}, {0.1, 0.01, 0.1}});
  plate.path = {{0, {0.05, 0.2, 0.05}, {0, 0, 0}, 0},
                {2, {0.05, 0.1, 0.05}, {0, 0, 0}, 0}};  // presses the cube by 1 cm
  cube.scene.tools.instruments = {plate};
  Graphics graphics = open_graphics(test::headless(), false);
  for (const bool reference : {false, true}) {
    Simulation simulation(cube.scene, reference ? nullptr : graphics.programs.get(), reference);
    CAPTURE(reference);
    const StaticReport report = simulation.solve_static();
    CHECK(report.converged);
    CHECK(simulation.time() == 2);
    const std::vector<ToolPlace> places = simulation.tool_places();
    CHECK(places.back().pose.origin.y() == Approx(0.1));
    const State before = simulation.state();
    simulation.step();
    const State after = simulation.state();
    double farthest = 0;
    for (std::size_t v = 0; v < before.displacement.size(); ++v)
      farthest = std::max(farthest, (after.displacement[v] - before.displacement[v]).norm());
    CHECK(farthest < 1e-6);  // nothing lets go of it
  }
}

TEST_CASE("a body that falls far onto the ground ends at rounding, whatever its stiffness", "[static]") {
  for (const double height : {0.2, 0.4, 1.0})
    for (const double modulus : {1e4, 1e5, 1e6, 1e7}) {
      FreeCube cube;
      cube.scene.bodies[0].transform.translate = {0, height, 0};
      cube.scene.bodies[0].material.young_modulus = modulus;
      Simulation simulation(cube.scene, nullptr, true);
      const StaticReport report = simulation.solve_static();
      CAPTURE(height, modulus, describe(report));
      CHECK(report.converged);
      CHECK(report.newton_iterations < 200);
      CHECK(simulation.newton_tool_loads().at(0).force.y() == Approx(9.81).epsilon(1e-6));
    }
}

TEST_CASE("a search with news finds the same to the bit, and stops when it is asked to", "[static]") {
  const auto found = [](const std::function<void(const StaticReport&)>& news) {
    Simulation simulation(FreeCube().scene, nullptr, true);
    CHECK(simulation.solve_static(news).converged);
    return simulation.state().displacement;
  };
  CHECK(found([](const StaticReport&) {}) == found({}));
  Simulation simulation(FreeCube().scene, nullptr, true);
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(simulation.solve_static([](const StaticReport&) {}, stop.get_token()).converged);
}

TEST_CASE("a search without an equilibrium says what is missing", "[static]") {
  FreeCube cube;
  CHECK(cube.error().empty());
  cube.scene.gravity.x() = 6;
  CHECK_THAT(cube.error(), Catch::StartsWith("cube.json: no static equilibrium after ") &&
                               Catch::EndsWith("iterations: bodies without supports go on moving; expected contact and "
                                               "friction that hold what has no fixed vertices (vertex 0 of cube)"));
  Simulation simulation(FreeCube().scene, nullptr, true);
  const auto error_of = [&](const StaticReport& report) -> std::string {
    try {
      require_equilibrium(simulation, report);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(error_of({0, 80, 4.26e-8, false}) ==
        "cube.json: no static equilibrium after 80 Newton iterations, relative residual 4.26e-08; expected a tolerance "
        "within reach, such as --set solver.tolerance=1e-07");
  CHECK_THAT(error_of({0, 80, 0.5, false}), Catch::EndsWith("expected a load that supports and contact can carry"));
  CHECK(error_of({0, 80, 1e-11, false, 1e-10, true, true}) ==
        "cube.json: no static equilibrium after 80 Newton iterations: tissue would go through what it meets; expected "
        "what meets to be kept apart, as steps of a motion do (fascia run without --static)");
  simulation.model.tools.clear();
  CHECK_THAT(error_of({0, 80, 0.5, false}),
             Catch::EndsWith("expected a constrained body and a load that it can carry"));
}

TEST_CASE("where the GPU nears an equilibrium slowly, Newton's method finishes it as exactly as elsewhere",
          "[static]") {
  const test::TemporaryFolder folder;
  write_mesh(folder / "beam.msh", make_box(8, 2, 3, {0.12, 0.03, 0.045}));
  Scene scene;
  scene.file = "beam.json";
  Body body;
  body.mesh = (folder / "beam.msh").string();
  body.elements = ElementOrder::quadratic;
  body.material = {1e5, 0.499, 1060, 0.01, MaterialModel::neo_hookean};
  body.fixed.push_back(BoxSelection{{-1, -1, -1}, {1e-4, 1, 1}});
  scene.bodies.push_back(body);
  Graphics graphics = open_graphics(test::headless(), false);
  const auto report_of = [&](double young_modulus) {
    scene.bodies[0].material.young_modulus = young_modulus;
    return Simulation(scene, graphics.programs.get(), false).solve_static();
  };
  const StaticReport soft = report_of(1e5);
  CAPTURE(describe(soft));
  CHECK(soft.converged);
  CHECK(soft.newton_iterations > 0);
  CHECK(soft.relative_residual <= 1e-10);
  // Rounding of its pressure is more than that, but Newton's method ends there.
  const StaticReport stiff = report_of(1e8);
  CAPTURE(describe(stiff));
  CHECK(stiff.converged);
  CHECK(stiff.newton_iterations < 20);
  CHECK(stiff.relative_residual <= 1e-8);
}

TEST_CASE("a report says where rounding ended a search", "[static]") {
  CHECK(describe({0, 1, 1e-11, true, 1e-10}) == "static equilibrium after 1 Newton iteration, relative residual 1e-11");
  CHECK(describe({0, 12, 1e-9, true, 1e-10}) ==
        "static equilibrium after 12 Newton iterations, relative residual 1e-09, the rounding of double precision");
}

TEST_CASE("a scene with too many rigid pieces is refused whatever the solver", "[static]") {
  FreeCube cube;
  for (int i = 0; i < 40; ++i)
    cube.scene.tools.obstacles.push_back(
        {"ball " + std::to_string(i), SphereShape{{0, 0, 0}, 0.05}, {0, 1.0 + i, 0}, {0, 0, 0}, std::nullopt});
  CHECK_THROWS_WITH(Simulation(cube.scene, nullptr, true),
                    Catch::StartsWith("cube.json: contact: has 41 rigid pieces; expected at most 32"));
}

TEST_CASE("what is left of a static solve follows from the fall of its residual") {
  // From 1 to 1e-2 in 10 s; three more decades of the same pace take 15 s.
  CHECK(*seconds_left(1, 1e-2, 1e-5, 10) == Approx(15));
  CHECK(*seconds_left(1e-1, 1e-4, 1e-5, 3) == Approx(1));
  CHECK(!seconds_left(1, 1, 1e-5, 10));  // does not fall
  CHECK(!seconds_left(1, 2, 1e-5, 10));
  CHECK(!seconds_left(1, 1e-6, 1e-5, 10));  // done
  CHECK(!seconds_left(1, 0.1, 0, 10));      // no tolerance
}
