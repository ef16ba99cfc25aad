// The window's settings from one start to the next: recent files, the last folder, dismissed hints, theme, scale. A
// small JSON file, read as strictly as scenes; a broken one never prevents the start of the window.
#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace fascia {

struct UserSettings {
  static constexpr std::size_t kMostRecent = 12;
  static constexpr double kLeastScale = 0.6, kLargestScale = 2.5;

  std::vector<std::filesystem::path> recent;  // absolute, the latest first
  std::filesystem::path folder;               // of the dialogs; empty: none yet
  std::set<std::string> hints_done;
  bool first_run_done = false;  // the examples were shown
  bool light = false;           // theme of the panels
  double scale = 1;             // of the panels, times that of the monitor

  void opened(const std::filesystem::path& file);
  bool operator==(const UserSettings&) const = default;
};

/// Without the file, the result has defaults. Throws Error for any other content.
UserSettings read_user_settings(const std::filesystem::path& file);
void write_user_settings(const std::filesystem::path& file, const UserSettings& settings);

/// The settings of a running window and their file, which other windows change, too: every change is applied to the
/// current content of the file.
class UserStore {
 public:
  /// With an empty folder no file is read or written.
  explicit UserStore(const std::filesystem::path& folder);
  const UserSettings& now() const { return settings_; }
  /// One line about a failed read or write; empty if there was none. A broken file is kept beside the new one, as
  /// settings.json.broken.
  const std::string& warning() const { return warning_; }
  void change(const std::function<void(UserSettings&)>& change);

 private:
  void read();

  std::filesystem::path file_;
  UserSettings settings_;
  std::string warning_;
  bool broken_ = false;
};

}  // namespace fascia
