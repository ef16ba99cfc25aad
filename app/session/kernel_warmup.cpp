#include "app/session/kernel_warmup.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "base/number_text.h"
#include "sim/output/sample.h"
#include "sim/scene/scene_write.h"

extern char** environ;

namespace fascia {
namespace fs = std::filesystem;
namespace {

// [s] of CPU time: a run with cached kernels takes a fraction of it, a run that compiles them several times as much.
constexpr double kCompiles = 1;

// As an option of fascia run (sim/scene/grab_text.h): holds the tissue at `at`, after the first step.
std::string late_grab(const Eigen::Vector3d& at, double time_step) {
  return NumberText()
      .add("at=")
      .add(at.x())
      .add(',')
      .add(at.y())
      .add(',')
      .add(at.z())
      .add(";translate=0,0,0;start=")
      .add(1.5 * time_step)
      .add(";duration=")
      .add(time_step)
      .take();
}

}  // namespace

KernelWarmup::KernelWarmup(const fs::path& program, const Scene& scene, const Model& model, const fs::path& data_dir) {
  try {
    Scene copy = scene;
    copy.duration = 0;
    const fs::path folder = fs::temp_directory_path();
    scene_ = folder / ("fascia-kernels-" + std::to_string(getpid()) + ".json");
    write_file(scene_, scene_to_json(copy, folder));
    const std::string grab = late_grab(model.rest_positions[tip_vertex(model)], scene.solver.time_step);
    command_ = {"nice", "-n",        "10",    program.string(), "run",        scene_.string(),   "--context",
                "egl",  "--steps",   "3",     "--quiet",        "--data-dir", data_dir.string(), "--grab",
                grab,   "--kernels", "single"};
    begin();
  } catch (const std::exception&) {  // the program continues with its current kernels
    state_ = State::failed;
    remove_file();
  }
}

KernelWarmup::~KernelWarmup() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  remove_file();
}

void KernelWarmup::remove_file() {
  std::error_code ignored;
  if (!scene_.empty()) fs::remove(scene_, ignored);
}

void KernelWarmup::begin() {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
  std::vector<char*> arguments;
  for (std::string& word : command_) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int failed = posix_spawnp(&child_, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (!failed) return;
  child_ = -1;
  throw Error("nice", "cannot be run", "expected the program of coreutils");
}

KernelWarmup::State KernelWarmup::look() {
  if (state_ != State::running) return state_;
  int status = 0;
  rusage used{};
  const pid_t ended = wait4(child_, &status, WNOHANG, &used);
  if (ended == 0) return state_;
  child_ = -1;
  if (single_) {  // its kernels are few and small: what matters is whether those that follow are kept
    single_ = false;
    command_.back() = "auto";
    begin_again();
    return state_;
  }
  const double seconds = static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
  const bool worked = ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (worked && (seconds < kCompiles || (first_seconds_ > 0 && seconds < 0.5 * first_seconds_)))
    state_ = State::cached;
  else if (!worked || first_seconds_ > 0)
    state_ = State::failed;
  if (state_ != State::running) {
    remove_file();
    return state_;
  }
  first_seconds_ = seconds;  // the first run compiled; a second run shows whether the driver caches kernels
  begin_again();
  return state_;
}

void KernelWarmup::begin_again() {
  try {
    begin();
  } catch (const Error&) {
    state_ = State::failed;
    remove_file();
  }
}

}  // namespace fascia
