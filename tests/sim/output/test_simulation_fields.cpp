// Fields of exports: the recovered stress, and those of scenes with tools.
#include "sim/output/simulation_fields.h"

#include <catch2/catch.hpp>

#include "sim/accuracy/nodal_stress.h"
#include "sim/grab/build_model.h"
#include "tests/support/support.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("exports of a scene with tools have forces, gaps and tools at their places", "[export][contact]") {
  Scene scene = open_scene(test::source_dir() / "assets/scenes/cube.json");
  scene.bodies[0].fixed.clear();
  scene.solver.rest_speed = 0;
  double lowest = 1e9;
  for (const Vector3d& x : build_model(scene).rest_positions) lowest = std::min(lowest, x.y());
  scene.tools.ground = Ground{lowest, 0.5};
  Instrument ball;
  ball.name = "ball";
  ball.shape = ToolShape(SphereShape{{0, 0, 0}, 0.05});
  ball.path = {{0, {0, 1, 0}, {0, 0, 0}}, {1, {0, 2, 0}, {0, 0, 0}}};
  scene.tools.instruments.push_back(ball);
  Simulation simulation(scene, nullptr, true);
  for (int i = 0; i < 20; ++i) simulation.step();
  const State state = simulation.state();
  const StateFields fields = export_fields(simulation, state, "lying.vtu");
  Vector3d sum(0, 0, 0);
  for (const Vector3d& force : fields.contact_force) sum += force;
  double least = 1e9;
  for (const double gap : fields.contact_gap) least = std::min(least, std::isnan(gap) ? least : gap);
  CAPTURE(sum.transpose(), simulation.newton_tool_loads()[0].force.transpose(), least);
  CHECK((sum - simulation.newton_tool_loads()[0].force).norm() < 1e-9 * sum.norm());
  CHECK(sum.y() > 1);
  CHECK(std::abs(least) < 1e-2);
  REQUIRE(fields.tools.size() == 2);
  CHECK(fields.tools[1].name == "ball");
  Vector3d middle(0, 0, 0);
  for (const Vector3d& x : fields.tools[1].positions)
    middle += x / static_cast<double>(fields.tools[1].positions.size());
  CHECK((middle - Vector3d(0, 1 + state.time, 0)).norm() < 1e-6);
}

TEST_CASE("files with fields of vertices have the recovered stress, others do not pay for it", "[export]") {
  Simulation simulation(open_scene(test::source_dir() / "assets/scenes/cube.json"), nullptr, true);
  simulation.step();
  State state = simulation.state();
  const StateFields fields = export_fields(simulation, state, "cube.vtu");
  const NodalStress recovered = nodal_stress(simulation.model, state);
  CHECK(fields.recovered_von_mises == recovered.von_mises);
  CHECK(fields.recovered_stress == recovered.cauchy);
  CHECK(*std::max_element(recovered.von_mises.begin(), recovered.von_mises.end()) > 0);
  CHECK(export_fields(simulation, state, "cube.csv").recovered_von_mises.empty());
  state.displacement[0].x() = std::nan("");
  CHECK(export_fields(simulation, state, "cube.vtu").recovered_von_mises.empty());
}
