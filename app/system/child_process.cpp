#include "app/system/child_process.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <new>

#include "base/error.h"
#include "base/interrupt.h"

namespace fascia {
namespace {

using Clock = std::chrono::steady_clock;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

constexpr char kDone = 'd', kFailed = 'f';  // first byte of a child's message

void send(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = write(pipe, text.data(), text.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
}

[[noreturn]] void be_the_child(const std::function<std::string()>& work, int pipe, int output) {
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  std::string message;
  try {
    message = kDone + work();
  } catch (const std::bad_alloc&) {
    message = kFailed + std::string("needs more memory than there is; expected a smaller mesh");
  } catch (const std::exception& error) {
    message = kFailed + std::string(error.what());
  }
  std::cout.flush();
  std::cerr.flush();
  send(pipe, message);
  _exit(0);  // the parent cleans up its own resources
}

// Reads until the child closes its end or the time limit is reached.
std::string receive(int pipe, pid_t child, Clock::time_point end, bool& late) {
  std::string message;
  char block[4096];
  bool told = false;
  for (;;) {
    if (interrupted() && !told) told = kill(child, SIGTERM) == 0;
    late = late || Clock::now() > end;
    if (late) kill(child, SIGKILL);
    pollfd waiting{pipe, POLLIN, 0};
    if (poll(&waiting, 1, 200) <= 0) continue;
    const ssize_t count = read(pipe, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return message;
    message.append(block, static_cast<std::size_t>(count));
  }
}

std::string content_of(std::FILE* file) {
  std::string text;
  char block[4096];
  std::rewind(file);
  while (const std::size_t count = std::fread(block, 1, sizeof block, file)) text.append(block, count);
  return text;
}

}  // namespace

ChildReport run_in_child(const std::function<std::string()>& work, double timeout) {
  const auto fail = [](const std::string& what) {
    throw Error("fascia", what + ": " + std::strerror(errno), "expected room for one more process");
  };
  const File output(std::tmpfile(), std::fclose);
  if (!output) fail("no temporary file");
  int ends[2];
  if (pipe(ends) != 0) fail("no pipe");
  std::cout.flush();
  std::cerr.flush();
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    be_the_child(work, ends[1], fileno(output.get()));
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    fail("no child process");
  }
  bool late = false;
  ChildReport report;
  const std::string message = receive(ends[0], child, end, late);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  report.said = content_of(output.get());
  if (late) {
    char text[64];
    std::snprintf(text, sizeof text, "took longer than %g s and was ended", timeout);
    report.failure = text;
  } else if (WIFSIGNALED(status)) {
    report.failure = std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
  } else if (message.empty() || message[0] != kDone) {
    report.failure = message.size() > 1 ? message.substr(1)
                                        : "ended without a result, exit code " + std::to_string(WEXITSTATUS(status));
  } else {
    report.answer = message.substr(1);
  }
  return report;
}

}  // namespace fascia
