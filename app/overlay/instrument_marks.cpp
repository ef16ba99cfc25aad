#include "app/overlay/instrument_marks.h"

#include <imgui.h>

#include <cmath>

#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "sim/tool/shape_distance.h"

namespace fascia {

using Eigen::Vector3d;

namespace {

// The part of a tool that a hand looks at: the tip of a rod that points anywhere, the middle of the jaws.
Vector3d spot_of(const Tool& tool, const ToolPlace& place) {
  if (!tool.has_jaws) return place.pose.origin;
  return 0.5 * (tool.pose_of_piece(0, place).to_scene(middle_of(tool.shape)) +
                tool.pose_of_piece(1, place).to_scene(middle_of(tool.shape)));
}

}  // namespace

std::vector<InstrumentMark> instrument_marks(const Simulation& simulation, const std::vector<ToolLoad>& loads,
                                             std::optional<std::size_t> picked,
                                             const std::optional<ToolPlace>& commanded, bool waits) {
  const std::vector<Tool>& tools = simulation.model.tools;
  std::vector<InstrumentMark> marks;
  if (simulation.scene.tools.instruments.empty()) return marks;
  const std::vector<ToolPlace> places = simulation.tool_places();
  for (std::size_t t = tools.size() - simulation.scene.tools.instruments.size(); t < tools.size(); ++t) {
    InstrumentMark mark{spot_of(tools[t], places[t]), std::nullopt, std::nullopt, false};
    if (t < loads.size() && loads[t].points > 0) mark.force = loads[t].force.norm();
    if (picked == t && commanded) {
      mark.commanded = spot_of(tools[t], *commanded);
      mark.waits = waits;
    }
    if (mark.force || mark.commanded) marks.push_back(mark);
  }
  return marks;
}

void draw_instrument_marks(const MarkArea& area, const Session& session, const std::vector<InstrumentMark>& marks,
                           LabelPlaces& places) {
  const MarkSettings& shown = session.display().marks;
  const auto at = [&](const Vector3d& place) -> std::optional<ImVec2> {
    const auto pixel = pixel_of(session, place, area.width, area.height);
    if (!pixel) return std::nullopt;
    return ImVec2{area.x + static_cast<float>(pixel->x()), static_cast<float>(pixel->y())};
  };
  ImDrawList& list = area.list;
  list.PushClipRect({area.x, 0}, {area.x + area.width, area.height}, true);
  for (const InstrumentMark& mark : marks) {
    const auto here = at(mark.at), there = mark.commanded ? at(*mark.commanded) : std::nullopt;
    if (!here) continue;
    const float reach = ui::px(8);
    places.keep_clear({here->x - reach, here->y - reach, here->x + reach, here->y + reach});
    if (there && shown.grabs && std::hypot(there->x - here->x, there->y - here->y) > ui::px(3)) {
      const ImU32 color = ImGui::GetColorU32(ui::kWarning);
      list.AddLine(*here, *there, IM_COL32(0, 0, 0, 110), ui::px(3.5f));
      list.AddLine(*here, *there, color, ui::px(1.6f));
      list.AddCircle(*there, ui::px(6), IM_COL32(0, 0, 0, 110), 0, ui::px(3.5f));
      list.AddCircle(*there, ui::px(6), color, 0, ui::px(1.6f));
    }
    if (!mark.force || !shown.forces) continue;
    const std::string force = engineering(*mark.force, "N") + (mark.waits ? ", tissue is crushed" : "");
    const Box label = places.place(ui::pill_box(force, here->x + ui::px(44), here->y - ui::px(34)));
    ui::pill(list, force, 0.5f * (label.left + label.right), label.top, ui::kText);
  }
  list.PopClipRect();
}

}  // namespace fascia
