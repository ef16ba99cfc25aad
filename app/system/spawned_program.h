// Another program that runs beside this one: its input comes from here, its output is discarded or goes to a file.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fascia {

class SpawnedProgram {
 public:
  struct End {
    bool succeeded;      // exit code 0
    double cpu_seconds;  // of its own work, without the kernel's
  };

  /// `command` is the program, searched in PATH, and its arguments; `environment` is added to this program's; `output`
  /// is the file of stdout and stderr. Throws Error if it cannot be run.
  explicit SpawnedProgram(std::vector<std::string> command, const std::map<std::string, std::string>& environment = {},
                          const std::filesystem::path& output = "/dev/null");
  ~SpawnedProgram();  // ends it at once
  SpawnedProgram(SpawnedProgram&& other) noexcept;
  SpawnedProgram& operator=(SpawnedProgram&&) = delete;

  void write(std::string_view text);  // to its standard input
  /// The next line that it writes to its standard input, a socket that carries both ways; what has come until `most`
  /// seconds are over or the program has ended, if that is no whole line.
  std::string answered_line(double most);
  void ask_to_end() const;                       // SIGTERM
  std::optional<End> ended();                    // does not wait
  std::optional<End> wait_for_end(double most);  // [s]

 private:
  pid_t child_ = -1;
  int input_ = -1;
  std::optional<End> end_;
};

}  // namespace fascia
