#include "app/file_dialogs.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/opened.h"
#include "app/ui_style.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr ImGuiWindowFlags kModal = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;
constexpr const char* kOpen = "Open a scene, a mesh or a replay";
constexpr const char* kSave = "Save the scene";
constexpr const char* kExport = "Export the state of now";
constexpr const char* kRecent = "recent files";

void center_next_window() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
}

bool escape_pressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)); }

// Keeps the up and down keys, which choose from the list, from leaving the field.
bool path_field(std::string& path, float width, bool focus = false) {
  if (focus || ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width);
  return ImGui::InputText("##path", &path, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackHistory,
                          [](ImGuiInputTextCallbackData*) { return 0; });
}

fs::path current_folder() {
  std::error_code ec;
  return fs::current_path(ec);
}

fs::path home() {
  const char* set = std::getenv("HOME");
  return set ? fs::path(set) : fs::path("/");
}

}  // namespace

bool FileDialogs::shipped(const fs::path& file) const {
  std::error_code ec;
  const fs::path inside = fs::weakly_canonical(file, ec).lexically_relative(fs::weakly_canonical(assets_, ec));
  return !inside.empty() && *inside.begin() != "..";
}

void FileDialogs::ask_open(const fs::path& open_file) {
  std::error_code ec;
  const fs::path beside = fs::absolute(open_file, ec).parent_path(), before = user_.now().folder;
  if (folder_.empty()) folder_ = !open_file.empty() && !shipped(open_file) ? beside : fs::is_directory(before, ec) ? before : current_folder();
  go_to(folder_);
  if (entries_.empty()) go_to(assets_ / "scenes");
  start_open_ = true;
}

void FileDialogs::ask_save(const fs::path& scene_file) {
  write_path_ = (current_folder() / (scene_file.stem().string() + ".json")).string();
  start_save_ = true;
}

void FileDialogs::ask_export(const fs::path& scene_file) {
  write_path_ = (current_folder() / (scene_file.stem().string() + ".vtu")).string();
  start_export_ = true;
}

void FileDialogs::ask_recent() { start_recent_ = true; }

void FileDialogs::opened(const fs::path& path) {
  std::error_code ec;
  user_.change([&](UserSettings& settings) {
    settings.opened(path);
    if (!shipped(path)) settings.folder = fs::absolute(path, ec).parent_path().lexically_normal();
  });
}

void FileDialogs::go_to(const fs::path& folder) {
  folder_ = folder.lexically_normal();
  typed_.clear();
  listed_for_.clear();
  marked_ = -1;
  entries_ = list_folder(folder_, openable_kinds()[kind_]);
}

void FileDialogs::places(Requests& requests) {
  const auto place = [&](const char* name, const fs::path& folder) {
    if (ImGui::Selectable(name, folder_ == folder.lexically_normal(), ImGuiSelectableFlags_DontClosePopups)) go_to(folder);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", folder.c_str());
  };
  place("Examples", assets_ / "scenes");
  place("Example meshes", assets_ / "meshes");
  place("Started in", current_folder());
  place("Home", home());
  place("Computer", "/");
  for (const fs::path& file : user_.now().recent) {
    ImGui::PushID(file.c_str());
    std::error_code ec;
    if (&file == &user_.now().recent.front()) ImGui::TextColored(ui::kDim, "Opened before");
    const bool there = fs::exists(file, ec);
    if (ImGui::Selectable(file.filename().c_str(), false, there ? 0 : ImGuiSelectableFlags_Disabled)) requests.open = file;
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s%s", file.c_str(), there ? "" : " (is not there any more)");
    ImGui::PopID();
  }
}

// The arrow keys walk through the list while the text field keeps the keyboard.
void FileDialogs::choose_by_keys() {
  const int count = static_cast<int>(entries_.size());
  int step = 0;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) step = 1;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) step = -1;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageDown))) step = 10;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageUp))) step = -10;
  if (step == 0) return;
  marked_ = std::clamp(marked_ + step, -1, count - 1);
  scroll_ = true;
}

bool FileDialogs::list() {
  if (folder_.has_parent_path() && folder_ != folder_.root_path() &&
      ImGui::Selectable("../", false, ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick)) {
    go_to((folder_ / "").parent_path().parent_path());
    return false;
  }
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const FolderEntry& entry = entries_[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const std::string name = entry.path.filename().string() + (entry.is_folder ? "/" : "");
    const bool clicked = ImGui::Selectable(name.c_str(), marked_ == i, ImGuiSelectableFlags_DontClosePopups);
    if (scroll_ && marked_ == i) ImGui::SetScrollHereY();
    ImGui::PopID();
    if (!clicked) continue;
    marked_ = i;
    if (!entry.is_folder) return true;
    go_to(fs::path(entry.path));
    return false;
  }
  scroll_ = false;
  if (entries_.empty()) ImGui::TextColored(ui::kDim, "Nothing here that fascia opens");
  return false;
}

void FileDialogs::draw_open(Requests& requests) {
  center_next_window();
  if (!ImGui::BeginPopupModal(kOpen, nullptr, kModal)) return;
  const float height = std::min(ui::px(360), 0.55f * ImGui::GetIO().DisplaySize.y), side = ui::px(170), wide = ui::px(420);
  ImGui::TextColored(ui::kDim, "%s", folder_.c_str());
  bool chosen = path_field(typed_, side + wide + ImGui::GetStyle().ItemSpacing.x, std::exchange(focus_, false));
  choose_by_keys();
  if (typed_ != listed_for_) {  // a part of a name narrows the list; a path is taken as it is
    listed_for_ = typed_;
    entries_ = list_folder(folder_, openable_kinds()[kind_], typed_.find('/') == std::string::npos ? typed_ : "");
    marked_ = -1;
  }
  ImGui::BeginChild("places", {side, height});
  places(requests);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("files", {wide, height});
  chosen |= list();
  ImGui::EndChild();

  ImGui::SetNextItemWidth(side);
  if (ImGui::BeginCombo("##kind", openable_kinds()[kind_].name)) {
    for (std::size_t i = 0; i < openable_kinds().size(); ++i)
      if (ImGui::Selectable(openable_kinds()[i].name, i == kind_)) {
        kind_ = i;
        go_to(fs::path(folder_));
      }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  chosen |= ImGui::Button("Open", {ui::px(100), 0});
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel", {ui::px(100), 0}) || escape_pressed();

  if (chosen) {
    std::error_code ec;
    fs::path path;
    if (marked_ >= 0) {
      path = entries_[static_cast<std::size_t>(marked_)].path;
    } else if (!typed_.empty()) {
      path = typed_.rfind("~/", 0) == 0 ? home() / typed_.substr(2) : folder_ / typed_;
      // A part of a name that only one file has is as good as its name; so is a path from where the program was started.
      if (!fs::exists(path, ec) && fs::exists(typed_, ec)) path = fs::absolute(typed_, ec);
      if (!fs::exists(path, ec) && entries_.size() == 1) path = entries_[0].path;
    }
    if (fs::is_directory(path, ec)) {
      go_to(path);
      focus_ = true;
    } else if (!path.empty()) {
      requests.open = path;
    }
  }
  if (requests.open || cancel) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void FileDialogs::draw_recent(Requests& requests) {
  if (!ImGui::BeginPopup(kRecent)) return;
  if (!last_session_.empty()) {
    if (ImGui::MenuItem("Continue where the last window ended")) requests.resume = last_session_;
    ImGui::Separator();
  }
  if (user_.now().recent.empty()) ImGui::TextColored(ui::kDim, "Nothing was opened yet");
  for (const fs::path& file : user_.now().recent) {
    std::error_code ec;
    const bool there = fs::exists(file, ec);
    ImGui::PushID(file.c_str());
    if (ImGui::MenuItem(file.filename().c_str(), nullptr, false, there)) requests.open = file;
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s%s", file.c_str(), there ? "" : " (is not there any more)");
    ImGui::PopID();
  }
  ImGui::EndPopup();
}

void FileDialogs::draw_write(const char* title, Writes what, Requests& requests) {
  center_next_window();
  if (!ImGui::BeginPopupModal(title, nullptr, kModal)) return;
  const bool entered = path_field(write_path_, ui::px(460));
  if (what == Writes::state) {
    for (const auto& [ending, help] : {std::pair{".vtu", "ParaView: displacement, velocity, strain, stress, J"},
                                       std::pair{".csv", "index,x,y,z of every vertex [m]"}, std::pair{".msh", "the deformed mesh, for Gmsh"},
                                       std::pair{".obj", "the deformed surface"}}) {
      if (ending != std::string(".vtu")) ImGui::SameLine();
      if (ImGui::RadioButton(ending, fs::path(write_path_).extension() == ending)) write_path_ = fs::path(write_path_).replace_extension(ending).string();
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    }
  }
  if (what == Writes::scene) {
    ImGui::Checkbox("Save with mesh", &with_mesh_);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("The file carries its meshes and tables and opens anywhere.\nOtherwise it refers to them by their paths.");
  }
  std::error_code ec;
  const bool exists = fs::exists(write_path_, ec);
  if (exists)
    ImGui::TextColored(ui::kWarning, "%s", shipped(write_path_) ? "This file was shipped with fascia and will be replaced." : "This file exists and will be replaced.");
  // Enter alone never replaces a file: the button has to be pressed.
  const bool write = ImGui::Button(exists ? "Replace" : what == Writes::scene ? "Save" : "Export", {ui::px(100), 0}) || (entered && !exists);
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel", {ui::px(100), 0}) || escape_pressed();
  const bool done = write && !write_path_.empty();
  if (done) (what == Writes::scene ? requests.save : requests.export_state) = write_path_;
  requests.save_with_mesh = done && with_mesh_;
  if (done || cancel) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void FileDialogs::draw(Requests& requests) {
  if (start_open_) ImGui::OpenPopup(kOpen);
  if (start_save_) ImGui::OpenPopup(kSave);
  if (start_export_) ImGui::OpenPopup(kExport);
  if (start_recent_) ImGui::OpenPopup(kRecent);
  start_open_ = start_save_ = start_export_ = start_recent_ = false;
  draw_open(requests);
  draw_write(kSave, Writes::scene, requests);
  draw_write(kExport, Writes::state, requests);
  draw_recent(requests);
}

}  // namespace fascia
