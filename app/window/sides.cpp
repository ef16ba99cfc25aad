#include "app/window/sides.h"

#include <utility>

namespace fascia {

bool Sides::asleep() const { return stage_.simulation().asleep() && (!split_ || split_->asleep()); }

void Sides::restart_facts() { stage_.state.facts = SceneFacts(tuned().simulation.scene, tuned().simulation.model); }

// The panels switch to the facts and the history of the other side.
void Sides::edit(bool b) {
  WindowState& state = stage_.state;
  if (state.editing_b == b) return;
  state.editing_b = b;
  std::swap(state.history, split_->history);
  restart_facts();
  state.history.accept(tunables_of(tuned(), state.grab));  // shared values may have changed at the other side
  state.statistics.diagnostics.reset();
  state.convergence.forget();
  stage_.diagnose = true;
}

void Sides::open() {
  split_ = std::make_unique<SplitView>(graphics_, *stage_.session, stage_.scene_now(), stage_.simulation().model);
  split_->history.restart(tunables_of(split_->b(), stage_.state.grab));
  lead();
  edit(true);  // A keeps its settings: changes go to B
}

void Sides::carry_out(CompareAsk ask, const Exchange& exchange) {
  if (ask != CompareAsk::open_or_close && !split_) return;
  end_drag();
  if (split_) lead();  // releases the grab at the other side, too
  switch (ask) {
    case CompareAsk::nothing:
      break;
    case CompareAsk::open_or_close:
      if (split_) {
        edit(false);
        close();
      } else {
        open();
      }
      break;
    case CompareAsk::edit_a:
      edit(false);
      break;
    case CompareAsk::edit_b:
      edit(true);
      break;
    case CompareAsk::copy_a: {
      GrabSettings grab = stage_.state.grab;
      set_tunables(split_->b(), grab, tunables_of(*stage_.session, grab));
      split_->restart_from(*stage_.session);
      break;
    }
    case CompareAsk::swap:
      exchange([&] { split_->swap(stage_.session); });
      std::swap(stage_.state.history, split_->history);
      break;
    case CompareAsk::keep_b:
      edit(false);
      exchange([&] {
        split_->swap(stage_.session);
        close();
      });
      break;
  }
  stage_.state.comparing = split_ != nullptr;
  restart_facts();
  stage_.state.convergence.forget();
  stage_.pacing.restart();
  stage_.diagnose = true;
}

void Sides::close() {
  split_.reset();
  stage_.state.comparing = stage_.state.editing_b = grab_in_b_ = false;
}

void Sides::step() {
  if (split_)
    split_->step(*stage_.session, held());
  else
    stage_.simulation().step();
}

void Sides::reset() {
  if (split_)
    split_->reset(*stage_.session);
  else
    stage_.simulation().reset();
}

void Sides::follow_error() {
  const bool follow = tuned().follow_true_error;  // the setting applies to both sides
  stage_.session->follow_true_error = follow;
  stage_.session->follow_error();
  if (!split_) return;
  split_->b().follow_true_error = follow;
  split_->b().follow_error();
}

void Sides::share() {
  if (split_) split_->share(*stage_.session);
}

void Sides::accept_tunables_of_a() {
  WindowState& state = stage_.state;
  (state.editing_b ? split_->history : state.history).accept(tunables_of(*stage_.session, state.grab));
}

void Sides::let_go() {
  stage_.mouse.cancel(held());
  stage_.hand.rest();
  stage_.give_up_brush();
  if (!stage_.simulation().replay()) stage_.simulation().set_grab({});
  if (split_) split_->b().simulation.set_grab({});
}

void Sides::end_drag() { stage_.mouse.end_drag(held()); }

void Sides::release() {
  stage_.simulation().set_grab({});
  if (split_) split_->b().simulation.set_grab({});
}

void Sides::hold() {
  stage_.mouse.hold(held());
  if (split_) lead();
}

void Sides::lead() { split_->lead(*stage_.session, held()); }

MouseTool::Picture Sides::picture_of_grab() const {
  const int width = stage_.framebuffer->width();
  return {split_ ? SplitView::areas(width, stage_.margins())[grab_in_b_ ? 1 : 0].width : width,
          stage_.framebuffer->height()};
}

bool Sides::points_at_b() const {
  return split_ && pointer_.x() >= SplitView::areas(stage_.framebuffer->width(), stage_.margins())[1].x;
}

Eigen::Vector2d Sides::pointer_in_side(bool b) const {
  if (!split_) return pointer_;
  return pointer_ - Eigen::Vector2d(SplitView::areas(stage_.framebuffer->width(), stage_.margins())[b ? 1 : 0].x, 0);
}

// Grabs that stay pull equally at both sides, so that the mouse can continue at either.
MouseTool::Picture Sides::to_side(Eigen::Vector2d& at, bool press) {
  pointer_ = at;
  if (press) grab_in_b_ = points_at_b();
  at = pointer_in_side(grab_in_b_);
  return picture_of_grab();
}

void Sides::after_mouse() {
  if (!split_) return;
  (grab_in_b_ ? *stage_.session : split_->b()).camera.look_as(held().camera);
  lead();
}

}  // namespace fascia
