// Has kernels compiled before a window needs them, on a thread and in a context of their own, so that no frame waits: the first step of
// a new kind takes seconds otherwise. What carries it over is the driver's cache on disk; where there is none, nothing is gained.
#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <thread>

#include "app/graphics.h"
#include "app/kernel_rehearsal.h"

namespace fascia {

class KernelWarmer {
 public:
  /// On the thread of `graphics`, as its end. `news`: called by the thread when more is compiled. Without a second context all counts as
  /// compiled at once.
  KernelWarmer(const Graphics& graphics, std::function<void()> news);
  ~KernelWarmer();  // waits for the program that is being compiled
  KernelWarmer(const KernelWarmer&) = delete;
  KernelWarmer& operator=(const KernelWarmer&) = delete;

  /// How far the kernels of a scene are compiled: all, where that cannot be. To be asked again and again; what is asked for anew comes
  /// first.
  Rehearsed compiled(const SolverSettings& settings, const Model& model);

 private:
  using Clock = std::chrono::steady_clock;
  struct Asked {
    KernelUse use;
    Model body;
    Rehearsed compiled = Rehearsed::nothing;
    Clock::time_point at;  // last
  };
  static constexpr std::size_t kMostTets = 100'000;  // a solver beside the window's costs as much memory
  void work();
  Asked* next();  // to be compiled; null: nothing is
  bool go_on(Asked& asked, Rehearsed compiled);

  std::filesystem::path shaders_;
  gl::LoadPath loads_;
  bool fusing_;
  std::function<void()> news_;
  std::unique_ptr<Context> context_;  // null: there is none
  std::mutex mutex_;                  // of what follows
  std::condition_variable changed_;
  std::list<Asked> asked_;  // entries stay where they are
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace fascia
