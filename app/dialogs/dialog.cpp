#include "app/dialogs/dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/ui/style.h"

namespace fascia {

bool begin_dialog(const char* title) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  return ImGui::BeginPopupModal(
      title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove);
}

bool name_field(std::string& name, float width, bool focus) {
  if (focus || ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width);
  return ImGui::InputText(
      "##name", &name,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackHistory,
      [](ImGuiInputTextCallbackData*) { return 0; });
}

bool dialog_button(const char* text) {
  const bool pressed = ImGui::Button(text, {ui::px(100), 0});
  if (!ImGui::IsItemFocused()) return pressed;
  const ImU32 color = ImGui::GetColorU32(ui::kAccent);
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), color, ui::px(5), 0,
                                      ui::px(1.5f));
  return pressed || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
}

bool escape_pressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false); }

}  // namespace fascia
