// What dialogs have in common: a modal window in the middle, a field for a name that keeps the keyboard, buttons that
// Enter presses.
#pragma once
#include <string>

namespace fascia {

/// True while it is open: widgets follow, then ImGui::EndPopup.
bool begin_dialog(const char* title);
/// True when Enter was pressed in it. `focus`: it takes the keyboard, as it does when the dialog appears. The up and
/// down keys do not leave it, so that they can walk through a list.
bool name_field(std::string& name, float width, bool focus);
/// Of the width that all buttons of dialogs have; framed while it has the keyboard.
bool dialog_button(const char* text);
bool escape_pressed();

}  // namespace fascia
