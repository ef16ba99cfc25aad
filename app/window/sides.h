// The two sides of the picture while two settings are compared: the side that the panels show, the side that the mouse
// acts on, and what the buttons do. While nothing is compared, the session that is open is both.
#pragma once
#include <functional>
#include <memory>

#include "app/compare/split_view.h"
#include "app/window/stage.h"

namespace fascia {

class Sides {
 public:
  Sides(Graphics& graphics, Stage& stage) : graphics_(graphics), stage_(stage) {}

  SplitView* split() { return split_.get(); }  // null: nothing is compared
  const SplitView* split() const { return split_.get(); }
  Session* second() const { return split_ ? &split_->b() : nullptr; }                            // side B
  Session& tuned() { return split_ && stage_.state.editing_b ? split_->b() : *stage_.session; }  // the panels show it
  Session& held() { return split_ && grab_in_b_ ? split_->b() : *stage_.session; }               // the mouse acts on it
  bool grab_in_b() const { return grab_in_b_; }
  bool asleep() const;  // all tissue that is shown

  /// Runs a change that puts another session in the place of the one that is open, and what belongs around it.
  using Exchange = std::function<void(const std::function<void()>& change)>;
  void carry_out(CompareAsk ask, const Exchange& exchange);
  void close();  // the scene that was compared is gone

  void step();
  void reset();
  void follow_error();  // once a frame
  void share();         // display, gravity and time step go over to the other side
  /// What a replay has changed at side A is no entry of its history.
  void accept_tunables_of_a();

  void let_go();    // of all grabs, at both sides; those of a replay hold on
  void end_drag();  // the grab that follows the mouse is let go of
  void release();   // nothing pulls at either side
  void hold();      // grabs that stay pull at both sides

  /// The mouse is at this pixel of the window's picture: moves `at` into the side that the mouse acts on, whose size it
  /// returns. With a `press` the mouse acts on the side below it from now on.
  MouseTool::Picture to_side(Eigen::Vector2d& at, bool press);
  MouseTool::Picture picture_of_grab() const;  // of the side that the mouse acts on
  void after_mouse();                          // both sides see and feel the same
  bool points_at_b() const;
  Eigen::Vector2d pointer_in_side(bool b) const;

 private:
  void open();
  void edit(bool b);
  void lead();  // both sides feel the same
  void restart_facts();

  Graphics& graphics_;
  Stage& stage_;
  std::unique_ptr<SplitView> split_;
  bool grab_in_b_ = false;
  Eigen::Vector2d pointer_{-1, -1};  // the mouse, in pixels of the window's picture
};

}  // namespace fascia
