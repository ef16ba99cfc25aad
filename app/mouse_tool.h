// What a drag of the mouse does to the scene: grab, orbit, pan, or move the section plane.
#pragma once
#include <Eigen/Core>

#include "app/grab.h"
#include "app/session.h"

namespace fascia {

class MouseTool {
 public:
  struct Picture {
    int width, height;
  };
  enum class Button { left, right, middle };

  /// Left on tissue takes hold of it, elsewhere it orbits; with `always_grab` it takes the nearest tissue. Others pan.
  void press(Button button, bool always_grab, const Eigen::Vector2d& at, Picture picture, Session& session,
             const GrabSettings& settings);
  /// Instead of press: the section plane of the picture follows the mouse along its normal.
  void press_section(Button button, const Eigen::Vector2d& at);
  void move(const Eigen::Vector2d& at, Picture picture, Session& session);
  void release(Button button, Session& session);
  /// Scene replaced or reset: everything is let go of.
  void cancel(Session& session);

  bool dragging() const { return tool_ != Tool::none; }
  Grab& grab() { return grab_; }
  /// Springs of the next step, to the solver.
  void pull(Session& session);

 private:
  enum class Tool { none, grab, orbit, pan, section };
  Tool tool_ = Tool::none;
  Button button_ = Button::left;
  Eigen::Vector2d last_{0, 0};
  Grab grab_;
};

}  // namespace fascia
