// Actions of the mouse in the scene: grab tissue, push it, take up a grab that stays, orbit, pan, or move the section
// plane.
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

  /// The left button grabs tissue, with Alt pushes it, and orbits beside it; with Shift it grabs the nearest tissue. On
  /// the mark of a grab that stays, left takes the grab up and right releases it. The other buttons pan.
  void press(Button button, Keys keys, const Eigen::Vector2d& at, Picture picture, Session& session,
             const GrabSettings& settings);
  /// Used instead of press(): the section plane of the picture follows the mouse along its normal.
  void press_section(Button button, const Eigen::Vector2d& at);
  void move(const Eigen::Vector2d& at, Picture picture, Session& session);
  /// With Control, or settings.stay, the grab stays at its place.
  void release(Button button, Keys keys, Session& session, const GrabSettings& settings);
  /// The wheel changes the depth of the grab that follows the mouse, or with Control the size of patches. Returns false
  /// if nothing changed.
  bool scroll(double notches, Keys keys, Session& session, GrabSettings& settings);
  /// Multiplies the size of patches by `factor`; the grab that follows the mouse changes at once.
  void resize(double factor, Session& session, GrabSettings& settings);
  void stay();  // the grab that follows the mouse stays at its place
  /// Releases the grab whose mark is at `at`, otherwise the last grab that stays.
  void let_go(const Eigen::Vector2d& at, Picture picture, Session& session);
  void let_go_staying(Session& session);  // releases all but the grab that follows the mouse
  /// Ends the current action of the mouse; grabs that stay keep their hold.
  void end_drag(Session& session);
  /// The scene was replaced or reset: releases everything.
  void cancel(Session& session);

  bool dragging() const { return tool_ != Tool::none; }
  bool orbiting() const { return tool_ == Tool::orbit || tool_ == Tool::pan; }  // or panning
  GrabSet& grabs() { return grabs_; }
  /// Passes the springs of the next step to the simulation.
  void pull(Session& session);
  /// Passes the current springs: after a release, whose grab must not pull although no step follows, and for a
  /// simulation that takes over the grabs.
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
