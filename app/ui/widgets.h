// Rows of the panels: a label at the left, a value or a control at the right, and a tooltip that explains it.
#pragma once
#include <imgui.h>

#include <string>
#include <vector>

#include "app/ui/label_places.h"
#include "app/ui/recent_values.h"

namespace fascia::ui {

/// A heading that collapses the rows below it; true while expanded.
bool section(const char* title, bool open_at_first = true);

/// Shows a tooltip while the last item is hovered.
void tooltip(const std::string& text);

/// "label          value", the value right-aligned; a tooltip if there is help.
/// `color`: of the value; null: that of text.
void fact(const char* label, const std::string& value, const std::string& help = "", const ImVec4* color = nullptr);

struct NumberField {
  std::string label, unit;
  double slider_min, slider_max;  // range of the slider
  double min, max;                // range of typed values
  bool logarithmic = false;
  bool integer = false;
  std::string help;
  std::string zero = "";  // shown for 0, and typed for it: "off"; empty: the number
};
/// A slider and its value in engineering notation; a click on the value, or a double click on the slider, starts typing
/// ("12.5 kPa"), and a drag of the value changes it in fine steps. True if the value changed.
bool number(const NumberField& field, double& value);

/// Starts a row whose control is drawn next and fills the remaining width.
void label(const char* text, const std::string& help = "");

/// Of a list that fills the row: a chosen text that is too long for a place beside the arrow takes that of the arrow.
ImGuiComboFlags combo_flags(const std::string& chosen);

inline constexpr auto kNeverRefused = [](const auto&) { return std::string(); };

/// A list of choices: `label_of` and `help_of` give the texts of each. One for which `refusal_of` gives a reason is
/// gray, with the reason in its tooltip. True if another one was chosen.
template <class Choice, class Label, class Help, class Refusal = decltype(kNeverRefused)>
bool choice(const char* name, const std::vector<Choice>& choices, Choice& chosen, Label label_of, Help help_of,
            Refusal refusal_of = kNeverRefused) {
  bool changed = false;
  label(name, help_of(chosen));
  ImGui::PushID(name);
  const std::string now = label_of(chosen);
  if (ImGui::BeginCombo("##choice", now.c_str(), combo_flags(now))) {
    for (const Choice one : choices) {
      const std::string refusal = refusal_of(one);
      const ImGuiSelectableFlags flags = refusal.empty() ? 0 : ImGuiSelectableFlags_Disabled;
      if (ImGui::Selectable(std::string(label_of(one)).c_str(), one == chosen, flags) && one != chosen) {
        chosen = one;
        changed = true;
      }
      tooltip(refusal.empty() ? std::string(help_of(one)) : refusal);
    }
    ImGui::EndCombo();
  } else {
    tooltip(help_of(chosen));
  }
  ImGui::PopID();
  return changed;
}

/// Text on a dark pill, centered on x, wrapped if it is wider than `widest` (0: never); without a list in the
/// background layer. Returns the box of the pill.
Box pill(ImDrawList& list, const std::string& text, float x, float y, const ImVec4& color, float widest = 0);
void pill(const std::string& text, float x, float y, const ImVec4& color);
Box pill_box(const std::string& text, float x, float y, float widest = 0);  // box of such a pill
/// What labels in this frame's picture keep clear of, apart from windows: pills in the background, and other texts.
void keep_clear(const Box& box);
const std::vector<Box>& kept_clear();

/// A line of the last values, from 0 to slightly above the largest, `height` points high.
void plot(const char* id, const RecentValues& history, float height);

/// A button that fills `width`; drawn in the accent color when `lit`.
bool button(const char* text, float width, bool lit = false);
bool button(const char* text, const std::string& help, float width, bool lit = false);

/// A button within a line of text; as wide as its text for width 0.
bool small_button(const char* text, const std::string& help, float width = 0);

/// Buttons of equal width in one row.
class ButtonRow {
 public:
  explicit ButtonRow(int count);
  bool add(const char* text, const std::string& help, bool lit = false);

 private:
  float width_;
  bool first_ = true;
};

/// Moves the current window so that all of it is visible, for example after the picture has become smaller.
void keep_inside();

/// True if it was changed.
bool checkbox(const char* text, bool& value, const std::string& help);

}  // namespace fascia::ui
