// Undo and redo of changes to a window's scene, and the resulting scene.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/window/tuning_history.h"
#include "base/error.h"
#include "tests/support/headless_stage.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct TuningDesk : HeadlessStage {
  using HeadlessStage::HeadlessStage;
  RecordingControl recording{stage, sides, false};
  KernelSwitch kernels{graphics, false, {}};
  TuningHistory tuning{graphics, stage, sides, recording, kernels};
  const UndoHistory& history() const { return stage.state.history; }
  std::size_t materials() { return sides.tuned().simulation.model.materials.size(); }
};

}  // namespace

TEST_CASE("changes are entries of the side that the panels show, and several are undone at once") {
  TuningDesk desk;
  desk.tuning.session_began();
  desk.tuning.follow();
  CHECK(desk.history().entries().empty());
  const bool b = GENERATE(false, true);
  if (b) desk.compare(CompareAsk::open_or_close);
  Session& session = desk.sides.tuned();
  const int opened = iterations_of(session);
  for (const int iterations : {21, 22, 23}) {
    set_iterations(session, iterations);
    desk.tuning.follow();
  }
  REQUIRE(desk.history().entries().size() == 3);
  desk.tuning.go_to(0);
  CHECK(iterations_of(session) == opened);
  desk.tuning.go_to(2);
  CHECK(iterations_of(session) == 22);
  desk.tuning.follow();
  CHECK(desk.history().done() == 2);
  CHECK(desk.history().entries().size() == 3);
  if (b) CHECK(iterations_of(*desk.stage.session) == opened);
}

TEST_CASE("values of a fit are set at once, and one undo takes them back") {
  TuningDesk desk("inclusion");
  desk.tuning.session_began();
  const std::vector<Material> before = desk.stage.simulation().model.materials;
  REQUIRE(before.size() > 1);
  const std::string region = desk.stage.simulation().scene.bodies[0].region_materials[0].first;
  desk.tuning.set_values({{"materials.default.young_modulus", 4321}, {"materials." + region + ".damping", 0.0123}});
  desk.tuning.follow();
  CHECK(desk.stage.simulation().model.materials[0].young_modulus == 4321);
  CHECK(desk.stage.simulation().model.materials[1].damping == 0.0123);
  REQUIRE(desk.history().entries().size() == 1);
  CAPTURE(desk.history().entries()[0].text);
  CHECK(desk.history().entries()[0].text.find("and 1 more") != std::string::npos);
  desk.tuning.go_to(0);
  CHECK(desk.stage.simulation().model.materials == before);
  CHECK_THROWS_AS(desk.tuning.set_values({{"materials.default.poisson_ratio", 0.7}}), Error);
  CHECK(desk.stage.simulation().model.materials == before);
}

TEST_CASE("a region loses its own material, and has it again after undo") {
  TuningDesk desk("inclusion");
  desk.tuning.session_began();
  const std::size_t before = desk.materials();
  std::vector<MaterialEntries> entries = tunables_of(*desk.stage.session, {}).materials;
  entries[0].region_materials.clear();
  desk.stage.diagnose = false;
  desk.stage.session->settle_ground();  // which reads positions of the solver that is replaced
  desk.tuning.set_materials(entries);
  desk.stage.session->settle_ground();
  CHECK(desk.materials() == before - 1);
  CHECK(desk.stage.state.facts.material_volume.size() == before - 1);
  CHECK(desk.stage.diagnose);
  desk.tuning.follow();
  REQUIRE(desk.history().entries().size() == 1);
  desk.tuning.go_to(0);
  desk.stage.session->settle_ground();
  CHECK(desk.materials() == before);
  CHECK(desk.stage.state.facts.material_volume.size() == before);
}

TEST_CASE("the scene in another unit keeps changed values, and the camera only if it was moved") {
  TuningDesk desk;
  desk.tuning.session_began();
  set_iterations(*desk.stage.session, 33);
  const Opened twice = desk.tuning.rescaled(2);
  CHECK(twice.scene.solver.iterations == 33);
  CHECK(desk.tuning.rescaled(1).scene.camera == desk.stage.simulation().scene.camera);
  const auto size = [](const Model& model) {
    Eigen::Vector3d low = model.rest_positions[0], high = low;
    for (const Eigen::Vector3d& x : model.rest_positions) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    return (high - low).norm();
  };
  CHECK(size(twice.model) == Approx(2 * size(desk.stage.simulation().model)));
  desk.stage.session->camera.zoom(0.5);
  CHECK(desk.tuning.rescaled(1).scene.camera == desk.stage.scene_now().camera);
}

TEST_CASE("a stroke of the brush is an entry, and is undone and redone") {
  TuningDesk desk;
  desk.tuning.session_began();
  desk.tuning.follow();
  const auto fixed = [&] { return desk.stage.simulation().model.fixed; };
  const std::vector<std::uint32_t> before = fixed();
  const std::vector<char> held = desk.stage.simulation().model.held();
  const auto free = static_cast<std::uint32_t>(std::find(held.begin(), held.end(), 0) - held.begin());
  const auto with = [&](std::uint32_t v) {
    return with_fixed(desk.stage.simulation().scene, desk.stage.simulation().model, std::vector{v}, true);
  };
  desk.tuning.set_fixed(with(free));
  desk.tuning.follow();
  REQUIRE(desk.history().entries().size() == 1);
  CHECK_THAT(desk.history().entries()[0].text, Catch::Contains("Fixed: ") && Catch::Contains(" vertices"));
  CHECK(fixed().size() == before.size() + 1);
  desk.tuning.go_to(0);
  CHECK(fixed() == before);
  CHECK(fixed_of(desk.stage.simulation().scene) == fixed_of(open_scene(source_dir() / "assets/scenes/cube.json")));
  desk.tuning.go_to(1);
  CHECK(fixed().size() == before.size() + 1);
  CHECK(desk.history().entries().size() == 1);

  INFO("not during a comparison, which keeps the history as it is");
  desk.compare(CompareAsk::open_or_close);
  desk.compare(CompareAsk::edit_a);
  CHECK_THROWS_AS(desk.tuning.go_to(0), Error);
  CHECK(desk.history().done() == 1);
  CHECK(fixed().size() == before.size() + 1);
}

TEST_CASE(
    "painting is an entry, and several are undone and redone at once, also beside a method that carries its law") {
  TuningDesk desk;
  desk.tuning.session_began();
  const auto paint = [&](std::uint32_t tet, const std::string& name, MaterialModel law) {
    MaterialOverride fresh;
    fresh.model = law;
    const Simulation& now = desk.stage.simulation();
    desk.tuning.set_painting(with_painted(now.scene, now.model, std::vector{tet}, name, fresh));
    desk.tuning.follow();
  };
  paint(3, "tumour", MaterialModel::st_venant_kirchhoff);
  CHECK(desk.materials() == 2);
  CHECK(desk.stage.state.facts.regions.size() == 2);
  CHECK(desk.history().entries().back().text == "Painted, tumour: 0 to 1 tet and 2 more");
  Session& session = desk.sides.tuned();
  SolverSettings settings = session.simulation.scene.solver;
  const Method before = settings.method;
  settings.method = Method::vertex_descent;
  settings.acceleration = Acceleration::none;
  session.simulation.set_settings(settings);
  desk.tuning.follow();
  paint(4, "cyst", MaterialModel::stable_neo_hookean);
  CHECK(desk.materials() == 3);
  REQUIRE(desk.history().entries().size() == 3);

  desk.tuning.go_to(0);
  CHECK(desk.materials() == 1);
  CHECK(desk.stage.simulation().scene.bodies[0].regions.empty());
  CHECK(desk.stage.simulation().scene.solver.method == before);
  desk.tuning.go_to(3);
  CHECK(desk.materials() == 3);
  CHECK(desk.stage.simulation().scene.solver.method == Method::vertex_descent);
  CHECK(desk.history().done() == 3);

  desk.compare(CompareAsk::open_or_close);
  desk.compare(CompareAsk::edit_a);
  CHECK_THROWS_WITH(desk.tuning.go_to(1), Catch::StartsWith("Fixed vertices, regions, elements and instruments"));
  CHECK(desk.history().done() == 3);
}

TEST_CASE("other elements are an entry, and the tissue goes on where it was") {
  TuningDesk desk;
  desk.tuning.session_began();
  desk.tuning.follow();
  for (int step = 0; step < 10; ++step) desk.stage.simulation().step();
  const Model linear = desk.stage.simulation().model;
  const State before = desk.stage.simulation().state();
  const auto counted = [&] { return desk.stage.simulation().model.rest_positions.size(); };
  desk.stage.session->camera.zoom(0.5);
  const std::optional<CameraSettings> camera = desk.stage.scene_now().camera;

  desk.tuning.set_elements({ElementOrder::quadratic});
  desk.tuning.follow();
  REQUIRE(desk.history().entries().size() == 1);
  CHECK(desk.history().entries()[0].text == "Elements: linear to quadratic");
  const Model& model = desk.stage.simulation().model;
  CHECK(model.is_quadratic(0));
  CHECK(desk.stage.scene_now().camera == camera);
  const State after = desk.stage.simulation().state();
  CHECK(after.time == before.time);
  REQUIRE(after.displacement.size() == counted());
  double farthest = 0, largest = 0;
  for (std::size_t v = 0; v < linear.rest_positions.size(); ++v) {
    farthest = std::max(farthest, (after.displacement[v] - before.displacement[v]).norm());
    largest = std::max(largest, before.displacement[v].norm());
  }
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [a, b] = kMidEdgeCorners[m];
      const Eigen::Vector3d middle =
          0.5 * (after.displacement[model.tets[t][a]] + after.displacement[model.tets[t][b]]);
      farthest = std::max(farthest, (after.displacement[model.mid_edges[t][m]] - middle).norm());
    }
  CAPTURE(largest, farthest);
  CHECK(largest > 0.001);
  CHECK(farthest < 1e-6 * largest);
  for (int step = 0; step < 5; ++step) desk.stage.simulation().step();

  desk.tuning.go_to(0);
  CHECK(counted() == linear.rest_positions.size());
  CHECK_FALSE(desk.stage.simulation().model.has_quadratic());
  desk.tuning.go_to(1);
  CHECK(desk.stage.simulation().model.is_quadratic(0));
}
