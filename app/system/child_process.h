// Work in a child process, so that what crashes or hangs there (a driver, a scene too large for memory) ends nothing
// else.
#pragma once
#include <functional>
#include <string>

namespace fascia {

struct ChildReport {
  std::string answer;   // what the work returned
  std::string said;     // on stdout and stderr
  std::string failure;  // "crashed (Segmentation fault)", "took longer than 600 s", an Error's text; empty: it returned
};

/// Runs `work` in a fork of this process and waits for it. Call it before any graphics context or thread is made.
/// Ctrl-C goes to the child, too. Throws Error if there can be no child.
ChildReport run_in_child(const std::function<std::string()>& work, double timeout);  // [s]

}  // namespace fascia
