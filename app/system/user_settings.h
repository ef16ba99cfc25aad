// What the window remembers of its user from one start to the next: files opened, the folder last looked into, hints
// that were understood, theme. A small JSON file, strict as scenes are; one that is broken never stops the window.
#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace fascia {

struct UserSettings {
  static constexpr std::size_t kMostRecent = 12;

  std::vector<std::filesystem::path> recent;  // absolute, the latest first
  std::filesystem::path folder;               // of the dialogs; empty: none yet
  std::set<std::string> hints_done;
  bool first_run_done = false;  // has seen the examples
  bool light = false;           // theme of the panels

  void opened(const std::filesystem::path& file);
  bool operator==(const UserSettings&) const = default;
};

/// Without the file, everything is as at first. Throws Error for anything that is not such a file.
UserSettings read_user_settings(const std::filesystem::path& file);
void write_user_settings(const std::filesystem::path& file, const UserSettings& settings);

/// The settings of a running window and their file, which other windows change, too: every change is made to what the
/// file holds then.
class UserStore {
 public:
  /// An empty folder: nothing is read or written.
  explicit UserStore(const std::filesystem::path& folder);
  const UserSettings& now() const { return settings_; }
  /// Of reading or writing, one line; empty when all is well. A broken file is kept beside the new one, as
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
