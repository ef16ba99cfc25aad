// Kernels that another process leaves in the driver's cache.
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "app/kernels/kernel_warmup.h"
#include "app/system/paths.h"
#include "sim/scene/scene.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

KernelWarmup::State waited(KernelWarmup& warmup) {
  using State = KernelWarmup::State;
  for (State before = State::running;;) {
    const State now = warmup.look();
    if (now != State::running && now != State::whole_steps) return now;
    if (before == State::whole_steps) REQUIRE(now == State::whole_steps);  // it does not go back
    before = now;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

long scenes_left() {
  long count = 0;
  const std::string name = "fascia-kernels-" + std::to_string(getpid());
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
    count += entry.path().filename().string().starts_with(name);
  return count;
}

}  // namespace

TEST_CASE("another process fills the driver's cache with the kernels of a scene, and leaves no file") {
  const std::filesystem::path data_dir = find_data_dir("");
  const Scene scene = open_scene(data_dir / "assets/scenes/cube.json");
  KernelWarmup warmup(FASCIA_BINARY, scene, data_dir);
  CHECK(warmup.look() == KernelWarmup::State::running);
  CHECK(scenes_left() == 1);
  CHECK(waited(warmup) == KernelWarmup::State::cached);
  CHECK(scenes_left() == 0);
}

TEST_CASE("a warm-up removes the scenes of programs that were killed, and no other file") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path(), data_dir = find_data_dir("");
  const pid_t killed = fork();
  if (killed == 0) _exit(0);
  REQUIRE(waitpid(killed, nullptr, 0) == killed);  // its number names nothing now
  const std::filesystem::path abandoned = folder / ("fascia-kernels-" + std::to_string(killed) + ".json"),
                              running = folder / ("fascia-kernels-" + std::to_string(getppid()) + ".json"),
                              other = folder / "fascia-kernels-list.json";
  for (const auto& path : {abandoned, running, other}) std::ofstream(path) << "{}";
  { KernelWarmup warmup(FASCIA_BINARY, open_scene(data_dir / "assets/scenes/cube.json"), data_dir); }
  CHECK(!std::filesystem::exists(abandoned));
  CHECK(std::filesystem::exists(running));
  CHECK(std::filesystem::exists(other));
  for (const auto& path : {running, other}) std::filesystem::remove(path);
}

TEST_CASE("a warm-up reports the failure of its process, and an abandoned one ends its process") {
  const std::filesystem::path data_dir = find_data_dir("");
  const Scene scene = open_scene(data_dir / "assets/scenes/cube.json");
  SECTION("no such program") {
    KernelWarmup warmup("/nowhere/fascia", scene, data_dir);
    CHECK(waited(warmup) == KernelWarmup::State::failed);
  }
  SECTION("no shaders") {
    KernelWarmup warmup(FASCIA_BINARY, scene, "/nowhere");
    CHECK(waited(warmup) == KernelWarmup::State::failed);
  }
  SECTION("given up") { KernelWarmup warmup(FASCIA_BINARY, scene, data_dir); }
  CHECK(scenes_left() == 0);
}
