// Runs work in a child process, so that a crash or hang there (a driver, a scene too large for memory) does not end the
// program.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

namespace fascia {

struct ChildReport {
  std::string answer;   // result of the work
  std::string said;     // output on stdout and stderr
  std::string failure;  // "crashed (Segmentation fault)", "took longer than 600 s", an Error's text; empty: success
};

/// `work` in a fork of this process. Create it before any graphics context or thread; several may run at once. Ctrl-C
/// reaches the children, too.
class ChildProcess {
 public:
  /// `timeout` [s]. Throws Error if no child can be created.
  ChildProcess(const std::function<std::string()>& work, double timeout);
  ~ChildProcess();  // ends the child
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool ended(int wait_ms);                               // waits that long at most
  const ChildReport& report() const { return report_; }  // once it has ended

 private:
  using Clock = std::chrono::steady_clock;
  void take_end();

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> output_;
  pid_t child_ = -1;  // negative: it has ended
  int pipe_ = -1;
  double timeout_;
  Clock::time_point end_;
  bool told_ = false, late_ = false;
  std::string message_;
  ChildReport report_;
};

/// Runs `work` in a child and waits for it.
ChildReport run_in_child(const std::function<std::string()>& work, double timeout);  // [s]

}  // namespace fascia
