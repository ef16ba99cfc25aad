#include "app/system/child_process.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>

#include "base/error.h"
#include "base/interrupt.h"

namespace fascia {
namespace {

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

std::string content_of(std::FILE* file) {
  std::string text;
  char block[4096];
  std::rewind(file);
  while (const std::size_t count = std::fread(block, 1, sizeof block, file)) text.append(block, count);
  return text;
}

}  // namespace

ChildProcess::ChildProcess(const std::function<std::string()>& work, double timeout)
    : output_(std::tmpfile(), std::fclose), timeout_(timeout) {
  const auto fail = [](const std::string& what) {
    throw Error("fascia", what + ": " + std::strerror(errno), "expected room for one more process");
  };
  if (!output_) fail("no temporary file");
  int ends[2];
  if (pipe(ends) != 0) fail("no pipe");
  std::cout.flush();
  std::cerr.flush();
  end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout));
  child_ = fork();
  if (child_ == 0) {
    close(ends[0]);
    be_the_child(work, ends[1], fileno(output_.get()));
  }
  close(ends[1]);
  pipe_ = ends[0];
  if (child_ >= 0) return;
  close(pipe_);
  fail("no child process");
}

ChildProcess::~ChildProcess() {
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  take_end();
}

bool ChildProcess::ended(int wait_ms) {
  char block[4096];
  while (child_ >= 0) {
    if (interrupted() && !told_) told_ = kill(child_, SIGTERM) == 0;
    late_ = late_ || Clock::now() > end_;
    if (late_) kill(child_, SIGKILL);
    pollfd waiting{pipe_, POLLIN, 0};
    if (poll(&waiting, 1, wait_ms) <= 0) return false;
    const ssize_t count = read(pipe_, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count > 0)
      message_.append(block, static_cast<std::size_t>(count));
    else
      take_end();  // the child has closed its end
  }
  return true;
}

void ChildProcess::take_end() {
  close(pipe_);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
  child_ = -1;
  report_.said = content_of(output_.get());
  if (late_) {
    char text[64];
    std::snprintf(text, sizeof text, "took longer than %g s and was ended", timeout_);
    report_.failure = text;
  } else if (WIFSIGNALED(status)) {
    report_.failure = std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
  } else if (message_.empty() || message_[0] != kDone) {
    report_.failure = message_.size() > 1 ? message_.substr(1)
                                          : "ended without a result, exit code " + std::to_string(WEXITSTATUS(status));
  } else {
    report_.answer = message_.substr(1);
  }
}

ChildReport run_in_child(const std::function<std::string()>& work, double timeout) {
  constexpr int kWait = 200;  // [ms]: the time limit and Ctrl-C do not end a wait
  ChildProcess child(work, timeout);
  while (!child.ended(kWait)) continue;
  return child.report();
}

}  // namespace fascia
