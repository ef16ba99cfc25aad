// A fit in a child process, by the program itself.
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <thread>

#include "app/fit/background_fit.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/reference/newton.h"
#include "sim/scene/scene_carry.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr const char* kYoungOfCube = "materials.default.young_modulus";

/// The shipped cube, and how far a vertex of one with E = 60 kPa sinks.
struct SunkCube {
  TemporaryFolder folder;
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  FitTask task{folder / "sunk.csv", {kYoungOfCube}, 0, true};

  SunkCube() {
    const Model softer =
        build_model(open_scene(source_dir() / "assets/scenes/cube.json", {std::string(kYoungOfCube) + "=60000"}));
    State state = initial_state(softer);
    reference::NewtonSolver(softer, scene.solver).solve_static(state);
    for (std::uint32_t v = 0; v < state.displacement.size(); ++v)
      if (state.displacement[v].y() < state.displacement[task.probe].y()) task.probe = v;
    write_file(task.measured, "probe_y_m\n" + std::to_string(state.displacement[task.probe].y()) + "\n");
    Model model = build_model(scene);
    scene = self_contained(scene, model.files);
  }
};

void wait_for(BackgroundFit& fit) {
  while (!fit.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace

TEST_CASE("a fit in the background finds values, and says how far it is", "[fit]") {
  const SunkCube cube;
  BackgroundFit fit(FASCIA_BINARY, cube.scene, cube.task);
  CHECK(!fit.found());
  wait_for(fit);
  INFO(fit.last_line());
  const auto found = fit.found();
  REQUIRE(found);
  REQUIRE(found->size() == 1);
  CHECK((*found)[0].key == kYoungOfCube);
  CHECK((*found)[0].value == Approx(60000).epsilon(1e-3));  // six digits of the displacement
  CHECK(std::isnan((*found)[0].low));                       // one value alone says nothing of the noise
  CHECK_THAT(fit.last_line(), Catch::Contains("report.html after"));
}

TEST_CASE("a fit in the background that fails says why", "[fit]") {
  SunkCube cube;
  cube.task.keys = {"materials.default.softness"};
  BackgroundFit failed(FASCIA_BINARY, cube.scene, cube.task);
  wait_for(failed);
  CHECK(!failed.found());
  CHECK_THAT(failed.last_line(), Catch::StartsWith("--free materials.default.softness"));
}

TEST_CASE("a fit in the background that nobody waits for is ended", "[fit]") {
  const SunkCube cube;
  const std::filesystem::path program = cube.folder / "endless", pid_file = cube.folder / "pid";
  write_file(program, "#!/bin/sh\necho $$ > '" + pid_file.string() + ".part'\nmv '" + pid_file.string() + ".part' '" +
                          pid_file.string() + "'\nexec sleep 100000\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  pid_t pid = 0;
  {
    const BackgroundFit left(program, cube.scene, cube.task);
    while (!std::filesystem::exists(pid_file)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    pid = std::stoi(read_file(pid_file));
    REQUIRE(kill(pid, 0) == 0);  // runs
  }
  CHECK(kill(pid, 0) == -1);
}
