// Which vertices are fixed: a brush that fixes and releases them.
#include <imgui.h>

#include "app/panels/panels.h"
#include "app/ui/widgets.h"

namespace fascia {

void fixed_panel(const PanelContext& context) {
  const Simulation& simulation = context.session.simulation;
  WindowState& state = context.state;
  ui::fact("Vertices", std::to_string(simulation.model.fixed.size()),
           "Fixed vertices, which stay where they are at rest: the black dots");
  if (state.comparing || simulation.uses_reference()) state.brush = Brush::off;
  ImGui::BeginDisabled(state.comparing || simulation.uses_reference());
  ui::ButtonRow tools(2);
  const auto tool = [&](const char* name, const char* help, Brush brush) {
    if (tools.add(name, help, state.brush == brush)) state.brush = state.brush == brush ? Brush::off : brush;
  };
  tool(
      "Fix",
      "Brush over the tissue: vertices within the ring are fixed when the button is released. [ and ], or Ctrl and the "
      "wheel, change its size. Esc puts the brush away; Shift + left still grabs",
      Brush::fix);
  tool("Release", "Brush over the tissue: fixed vertices within the ring are free when the button is released",
       Brush::release);
  ImGui::EndDisabled();
}

}  // namespace fascia
