#include "app/system/spawned_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "base/error.h"

extern char** environ;

namespace fascia {
namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& more) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    if (!more.contains(text.substr(0, text.find('=')))) all.push_back(text);
  }
  for (const auto& [name, value] : more) all.push_back(name + "=" + value);
  return all;
}

}  // namespace

SpawnedProgram::SpawnedProgram(std::vector<std::string> command, const std::map<std::string, std::string>& environment,
                               const std::filesystem::path& output) {
  int ends[2];  // a socket instead of a pipe: writing to a program that has ended then raises no signal
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Error(command.front(), std::string("cannot be run: ") + std::strerror(errno), "expected a free socket");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  std::vector<std::string> variables = environment_with(environment);
  const int failed = posix_spawnp(&child_, command.front().c_str(), &actions, nullptr, pointers(command).data(),
                                  pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  input_ = ends[1];
  if (!failed) return;
  close(input_);
  throw Error(command.front(), std::string("cannot be run: ") + std::strerror(failed), "expected an installed program");
}

SpawnedProgram::SpawnedProgram(SpawnedProgram&& other) noexcept
    : child_(std::exchange(other.child_, -1)), input_(std::exchange(other.input_, -1)), end_(other.end_) {}

SpawnedProgram::~SpawnedProgram() {
  if (input_ >= 0) close(input_);
  if (child_ <= 0 || end_) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

void SpawnedProgram::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = send(input_, text.data(), text.size(), MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // it has ended: ended() says so
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string SpawnedProgram::answered_line(double most) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + std::chrono::duration<double>(most);
  std::string line;
  while (Clock::now() < last) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(last - Clock::now());
    pollfd socket{input_, POLLIN, 0};
    if (poll(&socket, 1, static_cast<int>(left.count()) + 1) <= 0) continue;
    char letter = 0;
    if (recv(input_, &letter, 1, 0) != 1 || letter == '\n') break;
    line += letter;
  }
  return line;
}

void SpawnedProgram::ask_to_end() const {
  if (child_ > 0 && !end_) kill(child_, SIGTERM);
}

std::optional<SpawnedProgram::End> SpawnedProgram::ended() {
  if (end_ || child_ <= 0) return end_;
  int status = 0;
  rusage used{};
  const pid_t ended = wait4(child_, &status, WNOHANG, &used);
  if (ended == 0) return {};
  end_ = {ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0,
          static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec)};
  return end_;
}

std::optional<SpawnedProgram::End> SpawnedProgram::wait_for_end(double most) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + std::chrono::duration<double>(most);
  while (!ended() && Clock::now() < last) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return end_;
}

}  // namespace fascia
