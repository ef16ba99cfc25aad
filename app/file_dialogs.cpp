#include "app/file_dialogs.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/ui_style.h"
#include "sim/file.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostRecent = 6;
constexpr ImGuiWindowFlags kModal = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

// Scenes and meshes of a folder by name; of TetGen's pairs the .node file.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string ending = lower_ending(it->path());
    for (const char* known : {".json", ".fascia", ".msh", ".vtk", ".vtu", ".node", ".mesh"})
      if (ending == known) files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void center_next_window() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
}

bool path_field(std::string& path) {
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(ui::px(460));
  return ImGui::InputText("##path", &path, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
}

}  // namespace

void FileDialogs::ask_open() {
  shipped_ = files_in(assets_ / "scenes");
  here_ = files_in(".");
  start_open_ = true;
}

void FileDialogs::ask_save(const fs::path& scene_file) {
  std::error_code ec;
  save_path_ = (fs::current_path(ec) / (scene_file.stem().string() + ".json")).string();
  start_save_ = true;
}

void FileDialogs::opened(const fs::path& path) {
  recent_.erase(std::remove(recent_.begin(), recent_.end(), path), recent_.end());
  recent_.insert(recent_.begin(), path);
  if (recent_.size() > kMostRecent) recent_.resize(kMostRecent);
}

bool FileDialogs::list(const char* title, const std::vector<fs::path>& files) {
  if (files.empty()) return false;
  bool chosen = false;
  ImGui::TextColored(ui::kDim, "%s", title);
  ImGui::PushID(title);
  for (const fs::path& file : files) {
    ImGui::PushID(file.c_str());
    if (ImGui::Selectable(file.filename().c_str())) {
      open_path_ = file.string();
      chosen = true;
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
    ImGui::PopID();
  }
  ImGui::PopID();
  ImGui::Spacing();
  return chosen;
}

void FileDialogs::draw_open(Requests& requests) {
  center_next_window();
  if (!ImGui::BeginPopupModal("Open a scene or a mesh", nullptr, kModal)) return;
  bool chosen = path_field(open_path_);
  ImGui::BeginChild("files", {ui::px(460), std::min(ui::px(300), 0.5f * ImGui::GetIO().DisplaySize.y)});
  chosen |= list("Opened before", recent_);
  chosen |= list("Shipped with fascia", shipped_);
  chosen |= list("Current folder", here_);
  ImGui::EndChild();
  chosen |= ImGui::Button("Open", {ui::px(100), 0});
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel", {ui::px(100), 0}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (chosen && !open_path_.empty()) requests.open = open_path_;
  if (requests.open || cancel) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void FileDialogs::draw_save(Requests& requests) {
  center_next_window();
  if (!ImGui::BeginPopupModal("Save the scene", nullptr, kModal)) return;
  const bool entered = path_field(save_path_);
  std::error_code ec;
  const bool exists = fs::exists(save_path_, ec);
  if (exists) {
    const fs::path inside = fs::weakly_canonical(save_path_, ec).lexically_relative(fs::weakly_canonical(assets_, ec));
    const bool shipped = !inside.empty() && *inside.begin() != "..";
    ImGui::PushTextWrapPos(ui::px(460));
    ImGui::TextColored(ui::kWarning, "%s", shipped ? "This file was shipped with fascia and will be replaced." : "This file exists and will be replaced.");
    ImGui::PopTextWrapPos();
  }
  // Enter alone never replaces a file: the button has to be pressed.
  const bool save = ImGui::Button(exists ? "Replace" : "Save", {ui::px(100), 0}) || (entered && !exists);
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel", {ui::px(100), 0}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (save && !save_path_.empty()) requests.save = save_path_;
  if (requests.save || cancel) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void FileDialogs::draw(Requests& requests) {
  if (start_open_) ImGui::OpenPopup("Open a scene or a mesh");
  if (start_save_) ImGui::OpenPopup("Save the scene");
  start_open_ = start_save_ = false;
  draw_open(requests);
  draw_save(requests);
}

}  // namespace fascia
