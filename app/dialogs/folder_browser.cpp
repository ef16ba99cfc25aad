#include "app/dialogs/folder_browser.h"

#include <imgui.h>

#include <algorithm>
#include <cstdlib>

#include "app/ui/style.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

float files_width() {
  return std::min(ui::px(420), ImGui::GetIO().DisplaySize.x - FolderBrowser::places_width() - ui::px(56));
}

// The absolute path without a trailing slash.
fs::path plain_folder(const fs::path& folder) {
  std::error_code ec;
  return (fs::absolute(folder, ec) / "").lexically_normal().parent_path();
}

}  // namespace

fs::path started_folder() {
  std::error_code ec;
  return fs::current_path(ec);
}

fs::path home_folder() {
  const char* set = std::getenv("HOME");
  return set ? fs::path(set) : fs::path("/");
}

float FolderBrowser::places_width() { return ui::px(170); }
float FolderBrowser::width() { return places_width() + files_width() + ImGui::GetStyle().ItemSpacing.x; }

void FolderBrowser::go_to(const fs::path& folder, const FileKind& kind, const std::string& part) {
  folder_ = plain_folder(folder);
  entries_ = list_folder(folder_, kind, part);
  marked_ = -1;
  has_parent_ = part.empty() && folder_ != folder_.root_path();
  if (has_parent_) entries_.insert(entries_.begin(), {folder_.parent_path(), true});
}

void FolderBrowser::walk_by_keys() {
  int step = 0;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) step = 1;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) step = -1;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageDown))) step = 10;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageUp))) step = -10;
  if (step == 0) return;
  marked_ = std::clamp(marked_ + step, -1, static_cast<int>(entries_.size()) - 1);
  scroll_ = true;
}

std::optional<FolderEntry> FolderBrowser::draw(const std::vector<Place>& places, const std::function<void()>& more) {
  const float height = std::min(ui::px(360), 0.55f * ImGui::GetIO().DisplaySize.y);
  std::optional<FolderEntry> clicked;
  ImGui::BeginChild("places", {places_width(), height});
  for (const Place& place : places) {
    if (ImGui::Selectable(place.name.c_str(), folder_ == plain_folder(place.folder),
                          ImGuiSelectableFlags_DontClosePopups))
      clicked = {place.folder, true};
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", place.folder.c_str());
  }
  if (more) more();
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("files", {files_width(), height});
  if (const auto entry = draw_entries()) clicked = entry;
  ImGui::EndChild();
  return clicked;
}

std::optional<FolderEntry> FolderBrowser::draw_entries() {
  std::optional<FolderEntry> clicked;
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const FolderEntry& entry = entries_[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const std::string name =
        i == 0 && has_parent_ ? "../" : entry.path.filename().string() + (entry.is_folder ? "/" : "");
    if (ImGui::Selectable(name.c_str(), marked_ == i, ImGuiSelectableFlags_DontClosePopups)) {
      marked_ = i;
      clicked = entry;
    }
    if (scroll_ && marked_ == i) ImGui::SetScrollHereY();
    ImGui::PopID();
  }
  scroll_ = false;
  if (entries_.size() == (has_parent_ ? 1u : 0u)) ImGui::TextColored(ui::kDim, "No folders, and no files of this kind");
  return clicked;
}

}  // namespace fascia
