// The cores of llvmpipe's threads, observed from outside in a running program.
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "app/session/software_threads.h"
#include "sim/grab/build_model.h"
#include "tests/support/support.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

std::string first_word(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  std::string word;
  while (in >> word && word != key) {
  }
  in >> word;
  return word;
}

// The threads of `fascia run` after its first steps: name, and for every list of cores the number of threads that may
// run there.
using Cores = std::map<std::string, std::map<std::string, int>>;
Cores cores_of_threads(std::size_t workers) {
  const TemporaryFolder folder;
  const std::string threads = "LP_NUM_THREADS=" + std::to_string(workers), out = (folder / "state.csv").string();
  const std::string cube = (source_dir() / "assets/scenes/cube.json").string();
  const pid_t child = fork();
  if (child == 0) {
    execl("/usr/bin/env", "env", threads.c_str(), FASCIA_BINARY, "run", cube.c_str(), "--quiet", "--context", "osmesa",
          "--time", "1000", "--export", out.c_str(), "--every", "10", nullptr);
    _exit(127);
  }
  const bool stepped = eventually([&] { return !fs::is_empty(folder.path()); });
  Cores cores;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(child) + "/task"))
    ++cores[first_word(thread.path() / "status", "Name:")][first_word(thread.path() / "status", "Cpus_allowed_list:")];
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  REQUIRE(stepped);
  return cores;
}

std::string text_of(const Cores& cores) {
  std::string text;
  for (const auto& [name, lists] : cores)
    for (const auto& [list, count] : lists) text += std::to_string(count) + " " + name + " on " + list + "\n";
  return text;
}

}  // namespace

TEST_CASE("the input of a command determines the work for which threads are chosen", "[cli]") {
  using namespace fascia;
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  const Model model = build_model(scene);
  CHECK(workload_of(scene, model, false).tets == model.tets.size());
  CHECK(workload_of(scene, model, false).fused);
  CHECK(workload_of(scene, model, false).drawn);
  CHECK_FALSE(workload_of(scene, model, false, false).drawn);
  scene.solver.tolerance = 1e-4;
  CHECK_FALSE(workload_of(scene, model, false).fused);
  CHECK(workload_of(scene, model, true).fused);  // a march to equilibrium has a tolerance of its own
}

TEST_CASE("threads that run kernels each have a core of their own if there are enough", "[cli]") {
  cpu_set_t allowed;
  REQUIRE(sched_getaffinity(0, sizeof allowed, &allowed) == 0);
  const auto count = static_cast<std::size_t>(CPU_COUNT(&allowed));
  const std::string everywhere = first_word("/proc/self/status", "Cpus_allowed_list:");
  const Cores bound = cores_of_threads(count), free = cores_of_threads(count + 1);
  CAPTURE(count, text_of(bound), text_of(free));
  if (count > 16) {  // more than llvmpipe has threads: no thread is bound
    CHECK(bound.at("fascia").size() == 1);
    return;
  }
  for (const auto& [name, lists] : bound)
    if (name != "fascia") CHECK((lists.size() == 1 && lists.contains(everywhere)));
  std::map<std::string, int> lists = bound.at("fascia");
  --lists[everywhere];  // the main thread of the program
  std::set<int> counts;
  std::size_t cores = 0;
  for (const auto& [list, threads] : lists) {
    if (threads == 0) continue;
    CHECK(list.find_first_of(",-") == std::string::npos);
    counts.insert(threads);
    ++cores;
  }
  CHECK(cores == count);
  CHECK(counts.size() == 1);  // the same number on every core
  REQUIRE(free.at("fascia").size() == 1);
  CHECK(free.at("fascia").begin()->second > static_cast<int>(count));
  CHECK(free.at("fascia").contains(everywhere));
}
