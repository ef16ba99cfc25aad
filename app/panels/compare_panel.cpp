// Two settings side by side: the choice of the side that the panels below show, and the actions on both sides.
#include <imgui.h>

#include "app/panels/panels.h"
#include "app/ui/widgets.h"

namespace fascia {

void compare_panel(const PanelContext& context) {
  const WindowState& state = context.state;
  Requests& requests = context.requests;
  ui::ButtonRow sides(2);
  if (sides.add("Tune A", "The panels below show and change side A, at the left: the open scene", !state.editing_b))
    requests.compare = CompareAsk::edit_a;
  if (sides.add(
          "Tune B",
          "The panels below show and change side B, at the right. Both sides share display, gravity and time step",
          state.editing_b))
    requests.compare = CompareAsk::edit_b;
  ui::ButtonRow actions(4);
  if (actions.add("A to B", "B gets the settings and the state of A")) requests.compare = CompareAsk::copy_a;
  if (actions.add("Swap", "A becomes B and B becomes A")) requests.compare = CompareAsk::swap;
  if (actions.add("Keep B", "B becomes the scene and A is removed; Ctrl+Z brings the settings of A back"))
    requests.compare = CompareAsk::keep_b;
  if (actions.add("Close", "A stays the scene and B is removed (B)")) requests.compare = CompareAsk::open_or_close;
}

}  // namespace fascia
