// Asking for a path: to open a scene or a mesh, to save the scene. Lists what is shipped, what was opened and the current folder.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/view_state.h"

namespace fascia {

class FileDialogs {
 public:
  explicit FileDialogs(std::filesystem::path data_dir) : assets_(std::move(data_dir) / "assets") {}

  void ask_open();
  void ask_save(const std::filesystem::path& scene_file);  // suggests a name in the current folder
  void opened(const std::filesystem::path& path);          // for the list of recent ones
  /// Between ImGui::NewFrame and ImGui::Render; what was chosen is in `requests`.
  void draw(Requests& requests);

 private:
  void draw_open(Requests& requests);
  void draw_save(Requests& requests);
  bool list(const char* title, const std::vector<std::filesystem::path>& files);

  std::filesystem::path assets_;
  std::vector<std::filesystem::path> recent_, shipped_, here_;
  std::string open_path_, save_path_;
  bool start_open_ = false, start_save_ = false;
};

}  // namespace fascia
