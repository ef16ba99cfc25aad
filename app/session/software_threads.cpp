#include "app/session/software_threads.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace fascia {
namespace {

constexpr std::size_t kMostThreads = 16;  // of llvmpipe 22

// In the order of creation.
std::vector<int> threads_of_this_program() {
  std::vector<int> threads;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", none))
    threads.push_back(std::atoi(entry.path().filename().c_str()));
  std::sort(threads.begin(), threads.end());
  return threads;
}

// Whether a thread of a driver waits: before its first wait it may not have run yet, and then has no name.
bool waits(int thread) {
  std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t name_end = text.rfind(") ");
  return name_end == std::string::npos || text.compare(name_end + 2, 1, "S") == 0;
}

// "/proc/self" for the program's own, or "/proc/self/task/123".
std::string name_in(const std::string& folder) {
  std::string name;
  std::ifstream file(folder + "/comm");
  std::getline(file, name);
  return name;
}

// The cores on which the program may run: in a container, for example, fewer than the machine has.
std::vector<int> cores_of_this_program() {
  std::vector<int> cores;
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    for (int core = 0; core < CPU_SETSIZE; ++core)
      if (CPU_ISSET(core, &allowed)) cores.push_back(core);
  return cores;
}

}  // namespace

Workload workload_of(const Scene& scene, const Model& model, bool static_equilibrium, bool drawn) {
  return {scene.solver.method, model.tets.size(), drawn, static_equilibrium || scene.solver.tolerance == 0};
}

// llvmpipe's worker threads have a cost whenever they wait for each other: in a step of fused passes (gl/fused_pass.h)
// after every kernel, of which colors need many; otherwise at every dispatch, where waking and waiting take as long as
// the threads save on some thousands of tets. The rasterizer gains from every core, more than a step loses.
SoftwareThreads::SoftwareThreads(const Workload& workload) : before_(threads_of_this_program()) {
  constexpr std::size_t kTetsFused = 2000, kTetsOfColors = 8'000, kTetsPerDispatch = 5000;
  const std::size_t cores = std::clamp<std::size_t>(cores_of_this_program().size(), 1, kMostThreads);
  const std::size_t least = !workload.fused ? kTetsPerDispatch * info_of(workload.method).dispatches
                            : workload.method == Method::gauss_seidel ? kTetsOfColors
                                                                      : kTetsFused;
  setenv("LP_NUM_THREADS", std::to_string(workload.drawn || workload.tets >= least ? cores : 0).c_str(), 0);
}

void SoftwareThreads::spread() const {
  const std::vector<int> cores = cores_of_this_program();
  if (cores.size() > kMostThreads || std::to_string(cores.size()) != std::getenv("LP_NUM_THREADS")) return;
  std::vector<int> made;
  for (const int thread : threads_of_this_program())
    if (std::find(before_.begin(), before_.end(), thread) == before_.end()) made.push_back(thread);
  constexpr int kPatience = 1000;  // ms, on a busy machine
  for (int i = 0; i < kPatience && !std::all_of(made.begin(), made.end(), waits); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  // Threads that run kernels have no name of their own; those of the rasterizer and helpers do.
  const std::string program = name_in("/proc/self");
  std::size_t worker = 0;
  for (const int thread : made) {
    if (name_in("/proc/self/task/" + std::to_string(thread)) != program) continue;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cores[worker % cores.size()], &one);
    sched_setaffinity(thread, sizeof one, &one);
    ++worker;
  }
}

}  // namespace fascia
