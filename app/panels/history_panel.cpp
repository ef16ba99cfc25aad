// The changes so far, the latest first. A click undoes or redoes changes up to an entry.
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {

void history_panel(const PanelContext& context) {
  const UndoHistory& history = context.state.history;
  Requests& requests = context.requests;
  requests.copy_command |=
      ui::button("Copy command line",
                 "Copies the command line that opens this scene with the values of the sliders (Ctrl+Shift+C)",
                 ImGui::GetContentRegionAvail().x);
  constexpr float kRows = 8;  // further rows scroll
  const std::size_t count = history.entries().size();
  if (count == 0) {
    ImGui::TextWrapped("No changes yet.");
    return;
  }
  ImGui::BeginChild("entries",
                    {0, std::min(kRows, static_cast<float>(count) + 1) * ImGui::GetTextLineHeightWithSpacing()});
  for (std::size_t i = count + 1; i-- > 0;) {
    ImGui::PushID(static_cast<int>(i));
    const bool undone = i > history.done();
    const std::string text = i == 0 ? (history.complete() ? "As opened" : "Earlier") : history.entries()[i - 1].text;
    if (undone) ImGui::PushStyleColor(ImGuiCol_Text, ui::kDim);
    if (ImGui::Selectable(text.c_str(), i == history.done()) && i != history.done()) requests.history = i;
    if (undone) ImGui::PopStyleColor();
    ui::tooltip(text + (undone                ? ". A click redoes all changes up to this one"
                        : i == history.done() ? ". The current state"
                                              : ". A click undoes all later changes"));
    ImGui::PopID();
  }
  ImGui::EndChild();
}

}  // namespace fascia
