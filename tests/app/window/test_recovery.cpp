// The files that a window keeps against a crash, and the recovery of tissue that diverged.
#include <catch2/catch.hpp>

#include "app/window/recovery.h"
#include "base/file.h"
#include "tests/support/headless_stage.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

/// Makes the folder the current one.
struct Inside {
  std::filesystem::path before = std::filesystem::current_path();
  explicit Inside(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
  ~Inside() { std::filesystem::current_path(before); }
};

}  // namespace

TEST_CASE("a window that closes normally leaves its scene as the last session") {
  HeadlessStage desk;
  const TemporaryFolder folder;
  {
    Recovery recovery(desk.stage, desk.sides, folder / "state");
    recovery.look_for_left();
    CHECK_FALSE(recovery.left());
    CHECK(recovery.last_session().empty());
    recovery.remember_now_and_then();
    recovery.finish();
  }
  const Recovery next(desk.stage, desk.sides, folder / "state");
  REQUIRE(!next.last_session().empty());
  CHECK(Autosave::name_in(next.last_session()) == "cube");
  CHECK(read_replay(next.last_session()).scene.title == desk.stage.simulation().scene.title);
}

TEST_CASE("the file of a crashed window is resumed or forgotten") {
  HeadlessStage desk;
  const TemporaryFolder folder;
  const std::filesystem::path left = folder / "cube.999999999-1.fascia";
  write_file(left, "{}");
  Recovery recovery(desk.stage, desk.sides, folder.path());
  recovery.look_for_left();
  REQUIRE(recovery.left() == left);
  const bool resumes = GENERATE(true, false);
  if (resumes) {
    recovery.resumed(folder / "other.fascia");
    CHECK(recovery.left() == left);
    recovery.session_began();
    recovery.resumed(left);
  } else {
    recovery.forget_left();
  }
  CHECK_FALSE(recovery.left());
  recovery.finish();
  CHECK_FALSE(std::filesystem::exists(left));
}

TEST_CASE("diverged tissue returns to the last valid state, and repeated divergence pauses") {
  HeadlessStage desk;
  const TemporaryFolder folder;
  const Inside inside(folder.path());
  Recovery recovery(desk.stage, desk.sides, {});
  Simulation& simulation = desk.stage.simulation();
  State broken = initial_state(simulation.model);
  const std::vector<char> held = simulation.model.held();
  broken.displacement[static_cast<std::size_t>(std::find(held.begin(), held.end(), 0) - held.begin())] = {1e25, 0, 0};
  for (int time = 1; time <= 3; ++time) {
    CAPTURE(time);
    simulation.go_on_from(broken);
    for (int i = 0; i < 100 && !simulation.diverged(); ++i) simulation.step();
    REQUIRE(simulation.diverged());
    desk.stage.diagnose = false;
    recovery.follow();
    CHECK(desk.stage.diagnose);
    REQUIRE(desk.stage.messages.any());
    CHECK(desk.stage.messages.is_error() == (time == 3));
    CHECK(desk.stage.state.paused == (time == 3));
    CHECK(files_in(folder.path()) == (time == 3 ? 1 : 0));
  }
  CHECK_THAT(desk.stage.messages.text(), Catch::Contains("diverged") && Catch::Contains("repeats it"));
}
