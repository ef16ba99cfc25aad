// Asks for a path: to open a file, to save the scene, the state or a replay; and lists recently opened files.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/dialogs/folder_browser.h"
#include "app/dialogs/save_dialog.h"
#include "app/state/window_state.h"
#include "app/system/user_settings.h"

namespace fascia {

class FileDialogs {
 public:
  FileDialogs(const std::filesystem::path& data_dir, UserStore& user) : assets_(data_dir / "assets"), user_(user) {}

  void ask_open(const std::filesystem::path& open_file);     // begins in its folder, unless it is a shipped file
  void ask_save(const std::filesystem::path& scene_file);    // suggests its name
  void ask_export(const std::filesystem::path& scene_file);  // suggests its name
  void ask_replay();                                         // suggests a dated name
  void ask_recent();                                         // a menu at the mouse
  void set_last_session(const std::filesystem::path& file) {
    last_session_ = file;
  }                                                // to continue from that menu; empty: none
  void opened(const std::filesystem::path& path);  // adds it to the list of recent files
  /// Call between ImGui::NewFrame and ImGui::Render; the selection is added to `requests`.
  void draw(Requests& requests);

 private:
  void draw_open(Requests& requests);
  void draw_recent(Requests& requests);
  void go_to(const std::filesystem::path& folder);
  void recent_files(Requests& requests);
  std::filesystem::path typed_path() const;
  void offer_folder_of(const std::filesystem::path& scene_file);
  bool shipped(const std::filesystem::path& file) const;

  std::filesystem::path assets_, last_session_;
  UserStore& user_;
  FolderBrowser browser_;  // of the open dialog
  std::size_t kind_ = 0;
  bool focus_ = false;
  std::string typed_, listed_for_;
  std::filesystem::path scene_folder_;  // empty for a shipped scene
  SaveDialog scene_{
      "Save the scene",
      {{".json", ""}},
      {"Save with mesh",
       "The file carries its meshes and tables and opens anywhere.\nOtherwise it refers to them by their paths."}};
  SaveDialog state_{"Export the state",
                    {{".vtu", "ParaView: displacement, velocity, strain, stress, J"},
                     {".csv", "index,x,y,z of every vertex [m]"},
                     {".msh", "the deformed mesh, for Gmsh"},
                     {".obj", "the deformed surface"},
                     {".inp", "the scene, for Abaqus and CalculiX"}}};
  SaveDialog replay_{"Save the replay of this session", {{".fascia", ""}}};
  bool start_open_ = false, start_recent_ = false;
};

}  // namespace fascia
