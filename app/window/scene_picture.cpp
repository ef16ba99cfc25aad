#include "app/window/scene_picture.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "app/overlay/color_bar.h"
#include "app/overlay/instrument_marks.h"
#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/window/parts/governor.h"
#include "base/error.h"
#include "render/supersampler.h"

namespace fascia {
namespace {

// Of what the brush marks.
ImVec4 color_of(Brush brush) {
  if (brush == Brush::fix) return {0, 0, 0, 1};
  return brush == Brush::paint ? ui::kAccent : ImVec4(1, 1, 1, 1);
}

}  // namespace

ScenePicture::ScenePicture(Graphics& graphics, Overlay& overlay, Stage& stage, Sides& sides, const Observer& observer,
                           int samples)
    : graphics_(graphics),
      overlay_(overlay),
      stage_(stage),
      sides_(sides),
      observer_(observer),
      samples_(samples > 0             ? std::min(samples, samples_of_renderer())
               : gl::device().software ? 1
                                       : 4) {}

bool ScenePicture::update() {
  GLFWwindow* window = graphics_.context->window();
  std::unique_ptr<Framebuffer>& framebuffer = stage_.framebuffer;
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  if (width < 1 || height < 1 || glfwGetWindowAttrib(window, GLFW_ICONIFIED)) return false;
  if (framebuffer && framebuffer->width() == width && framebuffer->height() == height) return true;
  framebuffer.reset();  // freed first: two large framebuffers may not fit
  try {
    framebuffer = std::make_unique<Framebuffer>(width, height, samples_);
  } catch (const Error&) {
    if (samples_ <= 1) throw;
    framebuffer = std::make_unique<Framebuffer>(width, height, 1);
    stage_.messages.say("No memory for " + std::to_string(samples_) + " samples per pixel: drawn with one", true);
    samples_ = 1;
  }
  return true;
}

void ScenePicture::draw(int level) {
  set_quality(lowered(graphics_.live, level));
  const bool aims = !stage_.mouse.dragging() && !stage_.hand.picked() && !ImGui::GetIO().WantCaptureMouse;
  const auto look = [&](const Framebuffer& picture, const Session& session, bool b) {
    hover_.look(picture, session, aims ? std::optional(sides_.pointer_in_side(b)) : std::nullopt);
  };
  const Canvas canvas{*stage_.framebuffer, 1, stage_.panels_cover(), false};
  timer_.begin();
  if (SplitView* split = sides_.split()) {
    draw_comparison(*split, canvas, [&](std::size_t side, const Framebuffer& picture) {
      const bool b = side == 1;
      if (b == sides_.points_at_b()) look(picture, b ? split->b() : *stage_.session, b);
    });
  } else {
    draw_scene(canvas);
    look(*stage_.framebuffer, *stage_.session, false);
  }
  timer_.end();
  while (const auto took = timer_.take()) stage_.state.statistics.render.add(took->milliseconds);
}

void ScenePicture::set_quality(const Quality& quality) {
  stage_.session->look.quality = quality;
  if (Session* const second = sides_.second()) second->look.quality = quality;
}

bool ScenePicture::full() const { return stage_.session->look.quality == graphics_.still; }

void ScenePicture::draw_onto(Framebuffer& picture, bool panels) {
  const float scale = overlay_.scale_onto(picture);
  const Canvas canvas{picture, scale, panels ? static_cast<int>(scale * static_cast<float>(stage_.panels_cover())) : 0,
                      !panels};
  SplitView* const split = sides_.split();
  const Camera in_window = stage_.session->camera, in_window_b = split ? split->b().camera : in_window;
  const Quality of_window = stage_.session->look.quality;
  set_quality(graphics_.still);
  if (split)
    draw_comparison(*split, canvas);
  else
    draw_scene(canvas);
  set_quality(of_window);
  stage_.session->camera = in_window;
  if (split) split->b().camera = in_window_b;
  overlay_.draw_onto(picture, panels);
}

Image ScenePicture::still() {
  const Framebuffer& shown = *stage_.framebuffer;
  if (full() && !shows_pointer(shown)) return shown.read();
  constexpr int kSamples = 4;
  Framebuffer picture(shown.width(), shown.height(), std::min(kSamples, samples_of_renderer()));
  draw_onto(picture, stage_.state.show_panels);
  return picture.read();
}

void ScenePicture::frame_bodies() {
  const Margins edges = stage_.margins();
  const double width = stage_.framebuffer->width(),
               shown = std::max(0.1 * width, width - edges.left - edges.legend_left - edges.right),
               aspect = 1.0 / stage_.framebuffer->height();
  if (sides_.split())
    stage_.session->frame_bodies(0.5 * shown * aspect, {1, 1});
  else
    stage_.session->frame_bodies(width * aspect, {shown / width, 1});
  stage_.state.replay_camera = false;
}

void ScenePicture::show_tool(std::size_t tool) {
  Session& session = *stage_.session;
  const Tool& shown = session.simulation.model.tools[tool];
  const Eigen::Vector3d middle =
      shown.pose_of_piece(0, session.simulation.tool_places()[tool]).to_scene(middle_of(shown.shape));
  const double aspect = static_cast<double>(stage_.framebuffer->width()) / stage_.framebuffer->height();
  const Eigen::Vector4f clip = session.camera.projection(aspect, session.look.radius) * session.camera.view() *
                               middle.cast<float>().homogeneous();
  if (clip.head<2>().cwiseAbs().maxCoeff() > clip.w()) session.frame();
}

void ScenePicture::draw_scene(const Canvas& canvas) {
  Session& session = *stage_.session;
  const Framebuffer& picture = canvas.picture;
  const auto& d = stage_.state.statistics.diagnostics;
  const std::vector<GrabMark> grabs =
      grab_marks(session.simulation, d ? d->grab_forces : std::vector<GrabForce>(), &stage_.mouse.grabs());
  session.follow_range();
  session.follow_ground();
  session.highlighted = stage_.hand.picked();
  frame_picture(session.camera, session.extent, {picture.width(), picture.height(), margins_of(canvas)});
  session.draw(canvas.picture, arrows(grabs));
  overlay_.draw_list(picture, canvas.scale, [&](ImDrawList& list) {
    const MarkArea area{list, 0, static_cast<float>(picture.width()) / canvas.scale,
                        static_cast<float>(picture.height()) / canvas.scale};
    const MarkArea free = beside_docks(area, canvas);
    const float left = static_cast<float>(canvas.left) / canvas.scale;
    draw_legend(free, session, left);  // with the range of the colors just drawn
    LabelPlaces places({left, 0, area.width, area.height}, ui::px(kLabelGap));
    for (const Box& box : covered(canvas)) places.keep_clear(box);
    if (const auto legend = legend_box(free.box(), session, left)) places.keep_clear(*legend);
    draw_grab_marks(area, session, grabs, places);
    draw_instruments(area, session, stage_.state.instruments.readings.mean(), places);
    if (shows_pointer(picture)) draw_ring(area, session);
    draw_brush_marks(area, session, stage_.stroke.places(), color_of(stage_.state.brush.brush));
    if (&picture == stage_.framebuffer.get()) draw_lasso(area, stage_.lasso.curve());
    const Plots& plots = stage_.state.plots;
    if (plots.shown && d && d->probe)
      draw_probe(area, session, session.simulation.model.rest_positions[*plots.probe] + *d->probe);
  });
}

void ScenePicture::draw_comparison(SplitView& split, const Canvas& canvas,
                                   const std::function<void(std::size_t, const Framebuffer&)>& drawn) {
  Session& a = *stage_.session;
  Framebuffer& picture = canvas.picture;
  const float scale = canvas.scale;
  const std::optional<Diagnostics>& of_a = observer_.of_open_session();
  const SplitView::SideGrabs grabs = split.grabs(a, of_a, &stage_.mouse.grabs());
  a.highlighted = split.b().highlighted = stage_.hand.picked();
  a.follow_range(&split.b());
  a.follow_ground(&split.b());
  const Margins edges = margins_of(canvas);
  split.draw(a, picture, edges, grabs, drawn);
  overlay_.draw_list(picture, scale, [&](ImDrawList& list) {
    draw_legend(beside_docks({list, 0, static_cast<float>(picture.width()) / scale,
                              static_cast<float>(picture.height()) / scale},
                             canvas),
                a, static_cast<float>(canvas.left) / scale);
    split.draw_labels(list, a, picture.width(), picture.height(), edges, scale,
                      {of_a, true, stage_.state.editing_b, grabs, covered(canvas)});
    const std::array<SplitView::Area, 2> areas = SplitView::areas(picture.width(), edges);
    for (std::size_t side = 0; side < areas.size(); ++side) {
      const MarkArea marked = SplitView::area_of(list, areas[side], picture.height(), scale);
      LabelPlaces places(marked.box(), ui::px(kLabelGap));
      const std::optional<Diagnostics>& d = side == 0 ? of_a : split.diagnostics();
      draw_instruments(marked, side == 0 ? a : split.b(), d ? d->tool_loads : std::vector<ToolLoad>(), places);
    }
    if (!shows_pointer(picture)) return;
    const bool ring_in_b = stage_.mouse.grabs().following() ? sides_.grab_in_b() : sides_.points_at_b();
    const SplitView::Area area = SplitView::areas(picture.width(), edges)[ring_in_b ? 1 : 0];
    draw_ring(SplitView::area_of(list, area, picture.height(), scale), ring_in_b ? split.b() : a);
  });
}

// The ring at the mouse belongs to the window alone, and a video may take the window's picture.
bool ScenePicture::shows_pointer(const Framebuffer& picture) const {
  return &picture == stage_.framebuffer.get() && !(stage_.state.recording && full());
}

// The patch of a grab, or the patch that a grab at the mouse would hold.
void ScenePicture::draw_ring(const MarkArea& area, const Session& session) const {
  if (const Grab* grab = stage_.mouse.grabs().following())
    draw_patch_ring(area, session, grab->anchor(), session.camera.forward(), grab->patch_radius());
  else if (stage_.state.brush.in_hand() && stage_.state.brush.lasso)
    return;
  else if (const auto& spot = hover_.spot();
           spot && !stage_.mouse.dragging() && !stage_.hand.picked() && !ImGui::GetIO().WantCaptureMouse)
    draw_patch_ring(area, session, spot->point, spot->normal, stage_.state.grab.radius * session.look.radius);
}

void ScenePicture::draw_instruments(const MarkArea& area, const Session& session, const std::vector<ToolLoad>& loads,
                                    LabelPlaces& places) const {
  draw_instrument_marks(
      area, session,
      instrument_marks(session.simulation, loads, stage_.hand.picked(), stage_.hand.commanded(), stage_.hand.waits()),
      places);
}

Margins ScenePicture::margins_of(const Canvas& canvas) const {
  const Cover cover = canvas.alone ? Cover{} : cover_of(stage_.state);
  const int right = static_cast<int>(canvas.scale * cover.right),
            bottom = static_cast<int>(canvas.scale * cover.bottom);
  Margins margins = legend_margins(*stage_.session, canvas.picture.width() - right, canvas.picture.height() - bottom,
                                   canvas.scale, canvas.left);
  margins.right += right;
  margins.bottom = bottom;
  return margins;
}

// The part of an area that docked windows leave.
MarkArea ScenePicture::beside_docks(const MarkArea& area, const Canvas& canvas) const {
  const Cover cover = canvas.alone ? Cover{} : cover_of(stage_.state);
  return {area.list, area.x, area.width - cover.right, area.height - cover.bottom};
}

std::vector<Box> ScenePicture::covered(const Canvas& canvas) const {
  return canvas.alone ? std::vector<Box>() : overlay_.covered();
}

}  // namespace fascia
