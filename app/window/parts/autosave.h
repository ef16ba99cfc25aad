// Writes the state of a window at intervals, beside the frames, so that a crash loses only some seconds. Every window
// has its own file, named after its process. A window that closes normally leaves its file as the last session.
#pragma once
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

class Autosave {
 public:
  /// With an empty folder nothing is written.
  explicit Autosave(std::filesystem::path folder);
  ~Autosave();  // waits for a running write

  /// Whether the next write is due: some seconds after the last one, more if writing takes long, and never during a
  /// write.
  bool due() const;
  void wait_a_while();  // nothing is due for some seconds
  /// Starts to write, on another thread. `name` is the scene's name. Throws the error of the previous write; after an
  /// error nothing more is written.
  void keep(std::shared_ptr<const Replay> replay, const std::string& name);
  /// `file`, of another window, is removed after the next write.
  void replace(std::filesystem::path file) { outdated_.push_back(std::move(file)); }
  /// The window closes normally: its file becomes the last session.
  void finish();

  /// The newest file of a window that crashed. Removes older files after two weeks.
  std::optional<std::filesystem::path> left_behind() const;
  std::filesystem::path last() const;  // of the last window that closed normally; empty without one
  /// The scene's name in the name of an autosave file.
  static std::string name_in(const std::filesystem::path& file);

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path folder_, file_;
  std::vector<std::filesystem::path> outdated_;  // removed after the next write
  std::future<std::chrono::duration<double>> writing_;
  Clock::time_point next_ = Clock::now();
};

}  // namespace fascia
