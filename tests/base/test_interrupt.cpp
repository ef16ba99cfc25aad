// Signals of a process, seen from its parent: each case runs in a child, because handlers stay installed.
#include "base/interrupt.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>

using namespace fascia;

namespace {

/// Runs `work` in a child. Returns its exit code, or minus the signal that ended it.
template <class Work>
int end_of(Work&& work) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);                                                                         // against hangs
    for (const int number : {SIGINT, SIGTERM, SIGSEGV}) std::signal(number, SIG_DFL);  // not those of the test program
    _exit(work());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

TEST_CASE("the first signal sets the flag and requests the stop, the second one ends the program") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  CAPTURE(signal);
  CHECK(end_of([=] {
          catch_interrupts();
          const std::stop_token token = interrupt_token();
          if (interrupted() || token.stop_requested()) return 1;
          std::raise(signal);
          return interrupted() && token.stop_requested() && interrupt_token().stop_requested() ? 0 : 2;
        }) == 0);
  CHECK(end_of([=] {
          catch_interrupts();
          std::raise(signal);
          std::raise(signal);
          return 0;
        }) == -signal);
}

TEST_CASE("no signal is caught before the request") {
  CHECK(end_of([] {
          std::raise(SIGINT);
          return 0;
        }) == -SIGINT);
}

TEST_CASE("a pipe without a reader does not end the program") {
  CHECK(end_of([] {
          catch_interrupts();
          int ends[2];
          if (pipe(ends) != 0) return 1;
          close(ends[0]);
          return write(ends[1], "x", 1) == -1 && errno == EPIPE && !interrupted() ? 0 : 2;
        }) == 0);
  CHECK(end_of([] {
          catch_interrupts();
          std::raise(SIGXFSZ);
          return interrupted() ? 1 : 0;
        }) == 0);
}

TEST_CASE("work that may end at once exits with the code of an interruption, and only while it lasts") {
  CHECK(end_of([] {
          catch_interrupts();
          const EndAtOnce outer;
          { const EndAtOnce inner; }
          std::raise(SIGINT);
          return 0;
        }) == exit_interrupted);
  CHECK(end_of([] {
          catch_interrupts();
          { const EndAtOnce work; }
          std::raise(SIGINT);
          return interrupted() ? 7 : 0;
        }) == 7);
}
