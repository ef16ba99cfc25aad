#include "app/kernels/kernel_warmup.h"

#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

// [s] of CPU time: a run with cached kernels takes a fraction of it, a run that compiles them several times as much.
constexpr double kCompiles = 1;

}  // namespace

KernelWarmup::KernelWarmup(const fs::path& program, const Scene& scene, const fs::path& data_dir) : scene_(scene) {
  try {
    Scene timeless = scene;
    timeless.duration = 0;
    const fs::path folder = fs::temp_directory_path();
    copy_ = folder / ("fascia-kernels-" + std::to_string(getpid()) + ".json");
    write_file(copy_, scene_to_json(timeless, folder));
    command_ = {"nice", "-n",      "5",          program.string(),  "kernels",   copy_.string(), "--context",
                "egl",  "--quiet", "--data-dir", data_dir.string(), "--kernels", "single"};
    begin();
  } catch (const std::exception&) {  // the program continues with its current kernels
    state_ = State::failed;
    remove_file();
  }
}

KernelWarmup::~KernelWarmup() { remove_file(); }

void KernelWarmup::remove_file() {
  std::error_code ignored;
  if (!copy_.empty()) fs::remove(copy_, ignored);
}

// Without worker threads: beside a window that keeps all cores busy, threads of low priority mostly wait for each
// other.
void KernelWarmup::begin() { program_.emplace(command_, std::map<std::string, std::string>{{"LP_NUM_THREADS", "0"}}); }

KernelWarmup::State KernelWarmup::look() {
  if (state_ != State::running) return state_;
  const auto end = program_->ended();
  if (!end) return state_;
  if (single_) {  // its kernels are few and small: what matters is whether those that follow are kept
    single_ = false;
    command_.back() = "auto";
    begin_again();
    return state_;
  }
  const double seconds = end->cpu_seconds;
  if (end->succeeded && (seconds < kCompiles || (first_seconds_ > 0 && seconds < 0.5 * first_seconds_)))
    state_ = State::cached;
  else if (!end->succeeded || first_seconds_ > 0)
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
