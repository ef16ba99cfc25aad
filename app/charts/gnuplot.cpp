#include "app/charts/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <system_error>

#include "base/error.h"
#include "base/file.h"

extern char** environ;

namespace fascia {
namespace fs = std::filesystem;
namespace {

// Script and picture are passed as files: no pipe can break or fill up.
struct WorkFiles {
  fs::path picture, script, log;

  explicit WorkFiles(const fs::path& path) : picture(temporary_name(path)), script(picture), log(picture) {
    script += ".gp";
    log += ".log";
  }
  ~WorkFiles() {
    std::error_code ec;
    for (const fs::path& file : {picture, script, log}) fs::remove(file, ec);
  }
};

// gnuplot quotes the line, marks the error, then names it: the result is its last line that is not empty.
std::string last_line(const fs::path& log) {
  std::istringstream lines(read_file(log));
  std::string last = "no message";
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r^") != std::string::npos) last = line.substr(line.find_first_not_of(" \t"));
  return last;
}

// Exit status of gnuplot. Throws Error if it cannot be started.
int run(const fs::path& path, const WorkFiles& files) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, files.script.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, files.picture.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_addopen(&actions, 2, files.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  // A separate process group: Ctrl-C in the terminal must reach only fascia, so that the chart can be completed.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::string program = "gnuplot", default_settings = "-d";  // ignores the user's ~/.gnuplot
  char* argv[] = {program.data(), default_settings.data(), nullptr};
  pid_t child = -1;
  const int spawned = posix_spawnp(&child, "gnuplot", &actions, &attributes, argv, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (spawned != 0)
    throw Error(path.string(), std::string("gnuplot cannot be started: ") + std::strerror(spawned), kGnuplotPackage);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return escaped;
}

// Browsers show the title of an SVG file, for which gnuplot has no setting.
void set_title(const fs::path& picture, const std::string& title) {
  std::string svg = read_file(picture);
  const std::string theirs = "<title>Gnuplot</title>";
  if (const std::size_t at = svg.find(theirs); at != std::string::npos)
    svg.replace(at, theirs.size(), "<title>" + xml_text(title) + "</title>");
  write_file(picture, svg);
}

}  // namespace

bool gnuplot_installed() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / "gnuplot").c_str(), X_OK) == 0) return true;
  return false;
}

void run_gnuplot(const fs::path& path, const std::string& script, const std::string& title) {
  const WorkFiles files(path);
  write_file(files.script, script);
  const int status = run(path, files);
  std::error_code ec;
  if (status != 0 || fs::file_size(files.picture, ec) == 0 || ec)
    throw Error(path.string(),
                "gnuplot ended with status " + std::to_string(status) + " (" + last_line(files.log) + ")",
                "expected a working gnuplot and free disk space");
  if (lower_ending(path) == ".svg") set_title(files.picture, title);
  replace_file(files.picture, path);
}

}  // namespace fascia
