// Ctrl-C ends commands in an orderly manner: they finish the file being written and return 130.
#pragma once
#include <stop_token>

namespace fascia {

inline constexpr int exit_interrupted = 130;

/// SIGINT and SIGTERM set a flag; the second one ends the program at once. SIGPIPE and SIGXFSZ are ignored: a dead
/// child process or a file that may not grow is an error with a message instead of a silent end.
void catch_interrupts();
bool interrupted();
/// Stop is requested when interrupted() becomes true. For polling, not for callbacks: these would run in the signal
/// handler.
std::stop_token interrupt_token();

/// While an object exists, the first signal also ends the program at once, with exit code 130: for work that does not
/// check the flag and leaves no partial results.
class EndAtOnce {
 public:
  EndAtOnce();
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

}  // namespace fascia
