#include "app/replay_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/capture.h"
#include "app/ui_style.h"

namespace fascia {
namespace fs = std::filesystem;

void ReplayDialog::ask() {
  std::error_code ec;
  path_ = (fs::current_path(ec) / dated_name(".fascia")).string();
  start_ = true;
}

void ReplayDialog::draw(Requests& requests) {
  constexpr const char* kTitle = "Save the replay of this session";
  if (start_) ImGui::OpenPopup(kTitle);
  start_ = false;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove)) return;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(ui::px(460));
  const bool entered = ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  std::error_code ec;
  const bool exists = fs::exists(path_, ec);
  if (exists) ImGui::TextColored(ui::kWarning, "This file exists and will be replaced.");
  // Enter alone never replaces a file: the button has to be pressed.
  const bool save = ImGui::Button(exists ? "Replace" : "Save", {ui::px(100), 0}) || (entered && !exists);
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel", {ui::px(100), 0}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (save && !path_.empty()) requests.save_replay = path_;
  if (requests.save_replay || cancel) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace fascia
