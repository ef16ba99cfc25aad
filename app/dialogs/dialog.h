// The common parts of dialogs: a modal window in the center, a name field that keeps the keyboard focus, buttons that
// Enter presses.
#pragma once
#include <string>

namespace fascia {

/// True while the dialog is open: widgets follow, then ImGui::EndPopup.
bool begin_dialog(const char* title);
/// True if Enter was pressed in the field. `focus`: the field takes the keyboard focus, as it does when the dialog
/// appears. The up and down keys do not leave it, so that they can move through a list.
bool name_field(std::string& name, float width, bool focus);
/// A button of the common width of dialogs; framed while it has the keyboard focus.
bool dialog_button(const char* text);
bool escape_pressed();

}  // namespace fascia
