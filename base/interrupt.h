// Ctrl-C asks politely: commands finish the file being written and return 130.
#pragma once
#include <stop_token>

namespace fascia {

inline constexpr int exit_interrupted = 130;

/// SIGINT and SIGTERM set a flag; the second one ends the program at once. SIGPIPE and SIGXFSZ are ignored: a dead
/// child process or a file that may not grow is an error with a message, not an end without one.
void catch_interrupts();
bool interrupted();
/// Stop is requested when interrupted() becomes true. To be asked, not to hang callbacks on: these would run in the
/// signal's handler.
std::stop_token interrupt_token();

/// While one lives the first signal ends the program at once, too, with exit code 130: for work that does not look at
/// the flag and leaves nothing half done.
class EndAtOnce {
 public:
  EndAtOnce();
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

}  // namespace fascia
