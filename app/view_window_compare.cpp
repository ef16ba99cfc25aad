// The window while two settings are compared side by side: who is shown where, who is held, and what the buttons do.
#include <algorithm>

#include "app/panels.h"
#include "app/view_window.h"

namespace fascia {

int ViewWindow::panels_cover() const { return state_.show_panels ? static_cast<int>(panel_space()) : 0; }

// The panels show the other side: its facts, and its history.
void ViewWindow::edit(bool b) {
  if (state_.editing_b == b) return;
  state_.editing_b = b;
  std::swap(state_.history, split_->history);
  state_.facts = SceneFacts(tuned().simulation.model);
  state_.history.accept(dials_of(tuned(), state_.grab));  // what both share may have changed at the other side
  state_.statistics.diagnostics.reset();
  state_.convergence.forget();
  diagnose_ = true;
}

void ViewWindow::compare(CompareAsk ask) {
  if (ask != CompareAsk::open_or_close && !split_) return;
  let_go();
  hand_in_b_ = false;
  switch (ask) {
    case CompareAsk::nothing: break;
    case CompareAsk::open_or_close: {
      if (split_) {
        edit(false);
        split_.reset();
        break;
      }
      split_ = std::make_unique<SplitView>(graphics_, *session_, scene_now(), session_->simulation.model);
      split_->history.restart(dials_of(split_->b(), state_.grab));
      edit(true);  // A is as it was: what one wants to turn is the other
      break;
    }
    case CompareAsk::edit_a: edit(false); break;
    case CompareAsk::edit_b: edit(true); break;
    case CompareAsk::copy_a: {
      GrabSettings grab = state_.grab;
      set_dials(split_->b(), grab, dials_of(*session_, grab));
      split_->restart_from(*session_);
      state_.facts = SceneFacts(tuned().simulation.model);
      break;
    }
    case CompareAsk::swap:
      leave_recorded_session();
      split_->swap(session_);
      attempt([&] { begin_recording(); });
      std::swap(state_.history, split_->history);
      break;
    case CompareAsk::keep_b:
      edit(false);
      leave_recorded_session();
      split_->swap(session_);
      split_.reset();
      attempt([&] { begin_recording(); });
      break;
  }
  state_.comparing = split_ != nullptr;
  state_.facts = SceneFacts(tuned().simulation.model);
  state_.convergence.forget();
  pacing_.restart();
  diagnose_ = true;
}

void ViewWindow::let_go() {
  mouse_.cancel(held());
  if (!session_->simulation.replay()) session_->simulation.set_grab({});
  if (split_) split_->b().simulation.set_grab({});
}

MouseTool::Picture ViewWindow::picture_of_hand() const {
  const int width = framebuffer_->width();
  return {split_ ? SplitView::areas(width, panels_cover())[hand_in_b_ ? 1 : 0].width : width, framebuffer_->height()};
}

MouseTool::Picture ViewWindow::to_side(Eigen::Vector2d& at, bool press) {
  if (split_) {
    const std::array<SplitView::Area, 2> areas = SplitView::areas(framebuffer_->width(), panels_cover());
    const bool in_b = at.x() >= areas[1].x;
    if (press && mouse_.hands().empty() && in_b != hand_in_b_) {  // hands that stay are of the side that took them
      let_go();
      hand_in_b_ = in_b;
    }
    at.x() -= areas[hand_in_b_ ? 1 : 0].x;
  }
  return picture_of_hand();
}

void ViewWindow::after_mouse() {
  (hand_in_b_ ? *session_ : split_->b()).camera = held().camera;
  split_->lead(*session_, held());
}

void ViewWindow::draw_comparison(Framebuffer& picture, float scale, int left) {
  split_->draw(*session_, picture, left, arrows(marks()));
  overlay_.draw_list(picture, scale, [&](ImDrawList& list) {
    split_->draw_labels(list, *session_, picture.width(), picture.height(), left, scale, {diagnostics_of_a_, true, state_.editing_b});
  });
}

}  // namespace fascia
