// The state of a window, written now and then beside the frames, so that a crash loses some seconds only. Every window
// has a file of its own, named after its process; a window that ends well leaves it as the one that was last.
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
  /// An empty folder: nothing is written.
  explicit Autosave(std::filesystem::path folder);
  ~Autosave();  // waits for what is being written

  /// Whether it is time to look again: some seconds after the last time, more where writing takes long, and nothing is
  /// being written.
  bool due() const;
  void wait_a_while();  // nothing is due for some seconds
  /// Begins to write, on another thread. `name`: of the scene. Throws what the last writing threw; then nothing more is
  /// written.
  void keep(std::shared_ptr<const Replay> replay, const std::string& name);
  /// `file`, of another window, is removed once what is kept next is written.
  void replace(std::filesystem::path file) { outdated_.push_back(std::move(file)); }
  /// The window ends well: its file becomes the last one.
  void finish();

  /// What a window that did not end well left, the newest; what others left long ago is removed.
  std::optional<std::filesystem::path> left_behind() const;
  std::filesystem::path last() const;  // of the window that last ended well; empty: none
  /// The scene's name in the name of such a file.
  static std::string name_in(const std::filesystem::path& file);

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path folder_, file_;
  std::vector<std::filesystem::path> outdated_;  // once the next writing is done
  std::future<std::chrono::duration<double>> writing_;
  Clock::time_point next_ = Clock::now();
};

}  // namespace fascia
