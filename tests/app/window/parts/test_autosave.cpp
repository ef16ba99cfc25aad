// States that windows save: recovered after a crash, and kept apart from those of running windows.
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include "app/window/parts/autosave.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/scene/scene.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::shared_ptr<const Replay> replay() {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  const Model model = build_model(scene);
  return std::make_shared<const Replay>(Replay{scene, initial_state(model), {}, 0});
}

std::vector<std::filesystem::path> files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) found.push_back(entry.path());
  return found;
}

}  // namespace

TEST_CASE("a window's state is not offered while it runs, and ends with its last one after a normal exit") {
  const TemporaryFolder folder;
  {
    Autosave one(folder / "state");
    CHECK(one.due());
    one.keep(replay(), "my.cube");
    one.wait_a_while();
    CHECK_FALSE(one.due());
    one.finish();
  }
  REQUIRE(files(folder / "state").size() == 1);
  Autosave two(folder / "state");
  CHECK_FALSE(two.left_behind());
  CHECK(two.last() == folder / "state/my_cube.last.fascia");
  CHECK(Autosave::name_in(two.last()) == "my_cube");
  two.keep(replay(), "other");
  two.finish();
  CHECK(files(folder / "state").size() == 1);  // the last one only
  two.keep(replay(), "third");
  Autosave three(folder / "state");
  CHECK_FALSE(three.left_behind());  // this process still exists
}

TEST_CASE("the state of a killed process is offered by the next window") {
  const TemporaryFolder folder;
  const auto state = replay();
  const pid_t child = fork();
  if (child == 0) {
    Autosave autosave(folder / "state");
    autosave.keep(state, "cube");
    while (!autosave.due()) usleep(1000);  // written
    _exit(0);                              // without finish(), as a crash does
  }
  // The parent continues only after the child has written and ended.
  int status = 0;
  waitpid(child, &status, 0);
  Autosave next(folder / "state");
  const auto left = next.left_behind();
  REQUIRE(left);
  CHECK(Autosave::name_in(*left) == "cube");
  const Replay again = read_replay(*left);
  CHECK(again.start->displacement == state->start->displacement);
  CHECK(again.scene.title == state->scene.title);
  const std::filesystem::path old = folder / "state/old.999999999-1.fascia";
  write_file(old, "{}");
  std::filesystem::last_write_time(old, std::filesystem::file_time_type::clock::now() - std::chrono::hours(24 * 30));
  CHECK(next.left_behind() == left);
  CHECK_FALSE(std::filesystem::exists(old));
}

TEST_CASE("a state taken up by another window is removed only when that window's own state is on disk") {
  const TemporaryFolder folder;
  const std::filesystem::path left = folder / "left.fascia";
  write_file(left, "{}");
  {
    write_file(folder / "no_folder", "");
    Autosave failing(folder / "no_folder");
    failing.replace(left);
    failing.keep(replay(), "cube");
    failing.finish();
  }
  CHECK(std::filesystem::exists(left));
  Autosave autosave(folder / "state");
  autosave.replace(left);
  CHECK(std::filesystem::exists(left));
  autosave.keep(replay(), "cube");
  autosave.finish();
  CHECK_FALSE(std::filesystem::exists(left));
  CHECK(files(folder / "state").size() == 1);
}
