// The window's picture: the scene, its color bar, and what marks places of it.
#include <imgui.h>

#include "app/overlay/color_bar.h"
#include "app/ui/style.h"
#include "app/window/window.h"

namespace fascia {

std::vector<GrabMark> Window::marks() {
  const auto& d = state_.statistics.diagnostics;
  return grab_marks(session_->simulation, d ? d->grab_forces : std::vector<GrabForce>(), &mouse_.grabs());
}

std::vector<Box> Window::covered(const Framebuffer& picture) const {
  const bool scene_alone = &picture != framebuffer_.get() && !video_.settings().panels;
  return scene_alone ? std::vector<Box>() : overlay_.covered();
}

// How much a grab holds, or would hold where the mouse is.
void Window::draw_ring(const MarkArea& area, const Session& session) {
  if (const Grab* grab = mouse_.grabs().following())
    draw_patch_ring(area, session, grab->anchor(), session.camera.forward(), grab->patch_radius());
  else if (const auto& spot = hover_.spot(); spot && !mouse_.dragging() && !ImGui::GetIO().WantCaptureMouse)
    draw_patch_ring(area, session, spot->point, spot->normal, state_.grab.radius * session.look.radius);
}

void Window::draw_scene(Framebuffer& picture, float scale, int left) {
  Session& session = *session_;
  const std::vector<GrabMark> grabs = marks();
  session.follow_range();
  const Margins edges{static_cast<double>(left), legend_space(session, picture.width(), picture.height(), scale)};
  frame_picture(session.camera, session.extent, {picture.width(), picture.height(), edges});
  session.draw(picture, arrows(grabs));
  overlay_.draw_list(picture, scale, [&](ImDrawList& list) {
    const MarkArea area{list, 0, static_cast<float>(picture.width()) / scale,
                        static_cast<float>(picture.height()) / scale};
    draw_legend(area, session);  // with the range that the colors have just been drawn with
    LabelPlaces places({static_cast<float>(left) / scale, 0, area.width, area.height}, ui::px(kLabelGap));
    for (const Box& box : covered(picture)) places.keep_clear(box);
    if (const auto legend = legend_box(area.box(), session)) places.keep_clear(*legend);
    draw_grab_marks(area, session, grabs, places);
    draw_ring(area, session);
    const auto& d = state_.statistics.diagnostics;
    if (state_.plots.shown && d && d->probe)
      draw_probe(area, session, session.simulation.model.rest_positions[*state_.plots.probe] + *d->probe);
  });
}

void Window::draw() {
  const bool aims = !mouse_.dragging() && !ImGui::GetIO().WantCaptureMouse;
  render_timer_.begin();
  if (split_) {
    draw_comparison(*framebuffer_, 1, panels_cover(), [&](std::size_t side, const Framebuffer& picture) {
      const bool b = side == 1;
      if (b == points_at_b())
        hover_.look(picture, b ? split_->b() : *session_, aims ? std::optional(pointer_in_side(b)) : std::nullopt);
    });
  } else {
    draw_scene(*framebuffer_, 1, panels_cover());
    hover_.look(*framebuffer_, *session_, aims ? std::optional(pointer_) : std::nullopt);
  }
  render_timer_.end();
  while (const auto took = render_timer_.take()) state_.statistics.render.add(took->milliseconds);
}

}  // namespace fascia
