// The lists that dialogs for opening and saving share: places at the left, at the right what a folder holds, walked by
// mouse and keys.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/dialogs/folder_listing.h"

namespace fascia {

std::filesystem::path started_folder();  // the working folder
std::filesystem::path home_folder();

struct Place {
  std::string name;
  std::filesystem::path folder;
};

class FolderBrowser {
 public:
  /// Lists its folders and files of this kind, of which names contain `part`.
  void go_to(const std::filesystem::path& folder, const FileKind& kind, const std::string& part = "");
  const std::filesystem::path& folder() const { return folder_; }
  /// Without `part` the folder above it comes first.
  const std::vector<FolderEntry>& entries() const { return entries_; }

  /// The arrow and page keys mark an entry while a text field keeps the keyboard.
  void walk_by_keys();
  const FolderEntry* marked() const { return marked_ < 0 ? nullptr : &entries_[static_cast<std::size_t>(marked_)]; }
  void unmark() { marked_ = -1; }

  /// What was clicked; `more` draws below the places.
  std::optional<FolderEntry> draw(const std::vector<Place>& places, const std::function<void()>& more = {});
  static float width();  // of both lists [pixels]
  static float places_width();

 private:
  std::optional<FolderEntry> draw_entries();

  std::filesystem::path folder_;
  std::vector<FolderEntry> entries_;
  bool has_parent_ = false;  // entries_[0]
  int marked_ = -1;
  bool scroll_ = false;  // to the marked one
};

}  // namespace fascia
