// Asking for a path: to open something, to save the scene, to export the state; and the files that were opened before.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/folder_listing.h"
#include "app/user_settings.h"
#include "app/view_state.h"

namespace fascia {

class FileDialogs {
 public:
  FileDialogs(const std::filesystem::path& data_dir, UserStore& user) : assets_(data_dir / "assets"), user_(user) {}

  void ask_open(const std::filesystem::path& open_file);  // begins in its folder, unless it was shipped
  void ask_save(const std::filesystem::path& scene_file);  // suggests a name in the current folder
  void ask_export(const std::filesystem::path& scene_file);
  void ask_recent();  // a menu at the mouse
  void set_last_session(const std::filesystem::path& file) { last_session_ = file; }  // to continue from that menu; empty: none
  void opened(const std::filesystem::path& path);  // for the list of recent ones
  /// Between ImGui::NewFrame and ImGui::Render; what was chosen is in `requests`.
  void draw(Requests& requests);

 private:
  enum class Writes { scene, state };
  void draw_open(Requests& requests);
  void draw_recent(Requests& requests);
  void draw_write(const char* title, Writes what, Requests& requests);
  void go_to(const std::filesystem::path& folder);
  void places(Requests& requests);
  void choose_by_keys();
  bool list();
  bool shipped(const std::filesystem::path& file) const;

  std::filesystem::path assets_, last_session_;
  UserStore& user_;
  std::filesystem::path folder_;  // that is shown
  std::vector<FolderEntry> entries_;
  std::size_t kind_ = 0;
  int marked_ = -1;  // of the entries, by the arrow keys; -1: what is typed counts
  bool scroll_ = false, focus_ = false;
  std::string typed_, listed_for_, write_path_;
  bool start_open_ = false, start_save_ = false, start_export_ = false, start_recent_ = false;
  bool with_mesh_ = false;
};

}  // namespace fascia
