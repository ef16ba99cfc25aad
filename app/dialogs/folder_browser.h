// The lists of the dialogs for opening and saving: places at the left, the content of a folder at the right, navigated
// by mouse and keys.
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
  /// Lists its folders, and its files of this kind, whose names contain `part`.
  void go_to(const std::filesystem::path& folder, const FileKind& kind, const std::string& part = "");
  const std::filesystem::path& folder() const { return folder_; }
  /// Without `part` the parent folder comes first.
  const std::vector<FolderEntry>& entries() const { return entries_; }

  /// The arrow and page keys select an entry while a text field keeps the keyboard focus.
  void walk_by_keys();
  const FolderEntry* marked() const { return marked_ < 0 ? nullptr : &entries_[static_cast<std::size_t>(marked_)]; }
  void unmark() { marked_ = -1; }

  /// Returns the clicked entry; `more` draws below the places.
  std::optional<FolderEntry> draw(const std::vector<Place>& places, const std::function<void()>& more = {});
  static float width();  // of both lists [pixels]
  static float places_width();

 private:
  std::optional<FolderEntry> draw_entries();

  std::filesystem::path folder_;
  std::vector<FolderEntry> entries_;
  bool has_parent_ = false;  // entries_[0]
  int marked_ = -1;
  bool scroll_ = false;  // to the selected entry
};

}  // namespace fascia
