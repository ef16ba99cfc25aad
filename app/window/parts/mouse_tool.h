// What the mouse does to the scene: take hold of tissue, push it, take up a grab that was left, orbit, pan, or move the
// section plane.
#pragma once
#include <Eigen/Core>
#include <optional>

#include "app/session/session.h"
#include "sim/grab/grab_set.h"

namespace fascia {

class MouseTool {
 public:
  struct Picture {
    int width, height;
  };
  enum class Button { left, right, middle };
  struct Keys {
    bool shift = false, control = false, alt = false;
  };

  /// Left on tissue takes hold of it, with Alt pushes it, elsewhere orbits; with Shift it takes the nearest tissue; on
  /// the mark of a grab that stays it takes that up again, right lets go of it. Others pan.
  void press(Button button, Keys keys, const Eigen::Vector2d& at, Picture picture, Session& session,
             const GrabSettings& settings);
  /// Instead of press: the section plane of the picture follows the mouse along its normal.
  void press_section(Button button, const Eigen::Vector2d& at);
  void move(const Eigen::Vector2d& at, Picture picture, Session& session);
  /// With Control, or settings.stay, the grab stays where it is.
  void release(Button button, Keys keys, Session& session, const GrabSettings& settings);
  /// What the wheel does to grabs: the depth of the one that follows the mouse, with Control the size of patches.
  /// False: nothing.
  bool scroll(double notches, Keys keys, Session& session, GrabSettings& settings);
  /// Size of patches times `factor`, that of the grab that follows the mouse at once.
  void resize(double factor, Session& session, GrabSettings& settings);
  void stay();  // the grab that follows the mouse stays where it is
  /// The grab whose mark is at this place, or else the last one that stays.
  void let_go(const Eigen::Vector2d& at, Picture picture, Session& session);
  void let_go_staying(Session& session);  // of all but the one that follows the mouse
  /// Whatever the mouse is doing ends; grabs that stay hold on.
  void end_drag(Session& session);
  /// Scene replaced or reset: everything is let go of.
  void cancel(Session& session);

  bool dragging() const { return tool_ != Tool::none; }
  bool orbiting() const { return tool_ == Tool::orbit || tool_ == Tool::pan; }  // or panning
  GrabSet& grabs() { return grabs_; }
  /// Springs of the next step, to the simulation.
  void pull(Session& session);
  /// Those of now: for what was let go of, which pulls no more although no step follows, and for a simulation that has
  /// to hold on.
  void hold(Session& session);

 private:
  std::optional<std::size_t> mark_at(const Eigen::Vector2d& at, Picture picture, const Session& session) const;

  enum class Tool { none, grab, orbit, pan, section };
  Tool tool_ = Tool::none;
  Button button_ = Button::left;
  Eigen::Vector2d last_{0, 0};
  GrabSet grabs_;
};

}  // namespace fascia
