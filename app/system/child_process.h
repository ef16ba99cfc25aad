// Runs work in a child process, so that a crash or hang there (a driver, a scene too large for memory) does not end the
// program.
#pragma once
#include <functional>
#include <string>

namespace fascia {

struct ChildReport {
  std::string answer;   // result of the work
  std::string said;     // output on stdout and stderr
  std::string failure;  // "crashed (Segmentation fault)", "took longer than 600 s", an Error's text; empty: success
};

/// Runs `work` in a fork of this process and waits for it. Call it before any graphics context or thread is created.
/// Ctrl-C reaches the child, too. Throws Error if no child can be created.
ChildReport run_in_child(const std::function<std::string()>& work, double timeout);  // [s]

}  // namespace fascia
