// The two sides of the picture during a comparison of two settings: the side that the panels show, the side that the
// mouse acts on, and the actions of the buttons. Without a comparison the open session is both sides.
#pragma once
#include <functional>
#include <memory>

#include "app/compare/split_view.h"
#include "app/window/stage.h"

namespace fascia {

class Sides {
 public:
  Sides(Graphics& graphics, Stage& stage) : graphics_(graphics), stage_(stage) {}

  SplitView* split() { return split_.get(); }  // null without a comparison
  const SplitView* split() const { return split_.get(); }
  Session* second() const { return split_ ? &split_->b() : nullptr; }                            // side B
  Session& tuned() { return split_ && stage_.state.editing_b ? split_->b() : *stage_.session; }  // the panels show it
  Session& held() { return split_ && grab_in_b_ ? split_->b() : *stage_.session; }               // the mouse acts on it
  bool grab_in_b() const { return grab_in_b_; }
  bool asleep() const;  // whether all tissue shown is asleep

  /// Runs a change that replaces the open session, together with the work before and after the change.
  using Exchange = std::function<void(const std::function<void()>& change)>;
  void carry_out(CompareAsk ask, const Exchange& exchange);
  void close();  // the compared scene was closed

  void step();
  void reset();
  void follow_error();  // once a frame
  void share();         // copies display, gravity and time step to the other side
  /// Changes by a replay at side A are no entries of the history of the side.
  void accept_tunables_of_a();

  void
  let_go();  // of all grabs at both sides, the instrument and a stroke of the brush; grabs of a replay keep their hold
  void end_drag();  // releases the grab that follows the mouse
  void release();   // removes all springs at both sides
  void hold();      // grabs that stay pull at both sides

  /// The mouse is at this pixel of the window's picture. Moves `at` into the side that the mouse acts on and returns
  /// the size of that side. With a `press` the mouse acts on the side below it from then on.
  MouseTool::Picture to_side(Eigen::Vector2d& at, bool press);
  MouseTool::Picture picture_of_grab() const;  // of the side that the mouse acts on
  void after_mouse();                          // gives both sides the same view and springs
  bool points_at_b() const;
  Eigen::Vector2d pointer_in_side(bool b) const;

 private:
  void open();
  void edit(bool b);
  void lead();  // gives both sides the same springs
  void restart_facts();

  Graphics& graphics_;
  Stage& stage_;
  std::unique_ptr<SplitView> split_;
  bool grab_in_b_ = false;
  Eigen::Vector2d pointer_{-1, -1};  // the mouse, in pixels of the window's picture
};

}  // namespace fascia
