#include "app/kernels/kernel_warmup.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>

#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

// [s] of CPU time: a run with cached kernels takes a fraction of it, a run that compiles them several times as much.
constexpr double kCompiles = 1;

constexpr std::string_view kName = "fascia-kernels-", kEnding = ".json";  // around the number of a process

/// Removes the scenes of programs that were killed.
void remove_abandoned(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kName) || !name.ends_with(kEnding)) continue;
    const char* const end = name.data() + name.size() - kEnding.size();
    pid_t owner = 0;
    const auto read = std::from_chars(name.data() + kName.size(), end, owner);
    if (read.ec != std::errc() || read.ptr != end || owner <= 0) continue;
    if (kill(owner, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

KernelWarmup::KernelWarmup(const fs::path& program, const Scene& scene, const fs::path& data_dir) : scene_(scene) {
  try {
    Scene timeless = scene;
    timeless.duration = 0;
    const fs::path folder = fs::temp_directory_path();
    remove_abandoned(folder);
    copy_ = folder / (std::string(kName) + std::to_string(getpid()) + std::string(kEnding));
    write_file(copy_, scene_to_json(timeless, folder));
    command_ = {"nice",      "-n",  "5",       program.string(), "kernels",        copy_.string(),
                "--context", "egl", "--quiet", "--data-dir",     data_dir.string()};
    begin(Run::single);
  } catch (const std::exception&) {  // the program continues with its current kernels
    end(State::failed);
  }
}

KernelWarmup::~KernelWarmup() { end(state_); }

void KernelWarmup::end(State state) {
  state_ = state;
  std::error_code ignored;
  if (!copy_.empty()) fs::remove(copy_, ignored);
}

// Without worker threads: beside a window that keeps all cores busy, threads of low priority mostly wait for each
// other.
void KernelWarmup::begin(Run run) {
  run_ = run;
  std::vector<std::string> command = command_;
  command.insert(command.end(), {"--kernels", run == Run::single ? "single" : "auto"});
  if (run == Run::whole || run == Run::whole_again) command.push_back("--whole-steps");
  program_.emplace(command, std::map<std::string, std::string>{{"LP_NUM_THREADS", "0"}});
}

KernelWarmup::State KernelWarmup::look() {
  if (state_ != State::running && state_ != State::whole_steps) return state_;
  const auto ended = program_->ended();
  if (!ended) return state_;
  try {
    if (ended->succeeded || run_ == Run::single)
      follow(ended->cpu_seconds);
    else
      end(State::failed);
  } catch (const Error&) {  // no process can begin
    end(State::failed);
  }
  return state_;
}

void KernelWarmup::follow(double seconds) {
  switch (run_) {
    case Run::single:
      begin(Run::whole);
      break;
    case Run::whole:
    case Run::whole_again:
      if (seconds < kCompiles || (run_ == Run::whole_again && seconds < 0.5 * compile_seconds_)) {
        state_ = State::whole_steps;
        begin(Run::all);
      } else if (run_ == Run::whole_again) {
        end(State::failed);
      } else {
        compile_seconds_ = seconds;
        begin(Run::whole_again);
      }
      break;
    case Run::all:
      end(State::cached);
      break;
  }
}

}  // namespace fascia
