// The window while two settings are compared side by side: who is shown where, who is held, and what the buttons do.
#include <algorithm>

#include "app/overlay/color_bar.h"
#include "app/panels/panels.h"
#include "app/window/window.h"

namespace fascia {

int Window::panels_cover() const { return state_.show_panels ? static_cast<int>(panel_space()) : 0; }

Margins Window::margins() const {
  return {static_cast<double>(panels_cover()),
          legend_space(*session_, framebuffer_->width(), framebuffer_->height(), 1)};
}

// The panels show the other side: its facts, and its history.
void Window::edit(bool b) {
  if (state_.editing_b == b) return;
  state_.editing_b = b;
  std::swap(state_.history, split_->history);
  state_.facts = SceneFacts(tuned().simulation.scene, tuned().simulation.model);
  state_.history.accept(tunables_of(tuned(), state_.grab));  // what both share may have changed at the other side
  state_.statistics.diagnostics.reset();
  state_.convergence.forget();
  diagnose_ = true;
}

void Window::compare(CompareAsk ask) {
  if (ask != CompareAsk::open_or_close && !split_) return;
  mouse_.end_drag(held());
  if (split_) lead();  // the other side, too, is let go of
  switch (ask) {
    case CompareAsk::nothing:
      break;
    case CompareAsk::open_or_close: {
      if (split_) {
        edit(false);
        split_.reset();
        grab_in_b_ = false;
        break;
      }
      split_ = std::make_unique<SplitView>(graphics_, *session_, scene_now(), session_->simulation.model);
      split_->history.restart(tunables_of(split_->b(), state_.grab));
      lead();
      edit(true);  // A is as it was: what one wants to turn is the other
      break;
    }
    case CompareAsk::edit_a:
      edit(false);
      break;
    case CompareAsk::edit_b:
      edit(true);
      break;
    case CompareAsk::copy_a: {
      GrabSettings grab = state_.grab;
      set_tunables(split_->b(), grab, tunables_of(*session_, grab));
      split_->restart_from(*session_);
      state_.facts = SceneFacts(tuned().simulation.scene, tuned().simulation.model);
      break;
    }
    case CompareAsk::swap:
      leave_recorded_session();
      split_->swap(session_);
      record_anew();
      std::swap(state_.history, split_->history);
      break;
    case CompareAsk::keep_b:
      edit(false);
      leave_recorded_session();
      split_->swap(session_);
      split_.reset();
      grab_in_b_ = false;
      record_anew();
      break;
  }
  state_.comparing = split_ != nullptr;
  state_.facts = SceneFacts(tuned().simulation.scene, tuned().simulation.model);
  state_.convergence.forget();
  pacing_.restart();
  diagnose_ = true;
}

void Window::let_go() {
  mouse_.cancel(held());
  if (!session_->simulation.replay()) session_->simulation.set_grab({});
  if (split_) split_->b().simulation.set_grab({});
}

MouseTool::Picture Window::picture_of_grab() const {
  const int width = framebuffer_->width();
  return {split_ ? SplitView::areas(width, margins())[grab_in_b_ ? 1 : 0].width : width, framebuffer_->height()};
}

bool Window::points_at_b() const {
  return split_ && pointer_.x() >= SplitView::areas(framebuffer_->width(), margins())[1].x;
}

Eigen::Vector2d Window::pointer_in_side(bool b) const {
  if (!split_) return pointer_;
  return pointer_ - Eigen::Vector2d(SplitView::areas(framebuffer_->width(), margins())[b ? 1 : 0].x, 0);
}

// Grabs that stay pull at both sides alike, so that the mouse may go on at either.
MouseTool::Picture Window::to_side(Eigen::Vector2d& at, bool press) {
  if (press) grab_in_b_ = points_at_b();
  at = pointer_in_side(grab_in_b_);
  return picture_of_grab();
}

void Window::after_mouse() {
  (grab_in_b_ ? *session_ : split_->b()).camera.look_as(held().camera);
  lead();
}

void Window::lead() { split_->lead(*session_, held()); }

void Window::draw_comparison(Framebuffer& picture, float scale, int left,
                             const std::function<void(std::size_t, const Framebuffer&)>& drawn) {
  const SplitView::SideGrabs grabs = split_->grabs(*session_, diagnostics_of_a_, &mouse_.grabs());
  session_->follow_range(&split_->b());
  const Margins edges{static_cast<double>(left), legend_space(*session_, picture.width(), picture.height(), scale)};
  split_->draw(*session_, picture, edges, grabs, drawn);
  overlay_.draw_list(picture, scale, [&](ImDrawList& list) {
    draw_legend({list, 0, static_cast<float>(picture.width()) / scale, static_cast<float>(picture.height()) / scale},
                *session_);
    split_->draw_labels(list, *session_, picture.width(), picture.height(), edges, scale,
                        {diagnostics_of_a_, true, state_.editing_b, grabs, covered(picture)});
    const bool ring_in_b = mouse_.grabs().following() ? grab_in_b_ : points_at_b();
    const SplitView::Area area = SplitView::areas(picture.width(), edges)[ring_in_b ? 1 : 0];
    draw_ring(SplitView::area_of(list, area, picture.height(), scale), ring_in_b ? split_->b() : *session_);
  });
}

}  // namespace fascia
