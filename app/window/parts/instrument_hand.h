// An instrument in the hand of the user: the mouse commands its place, and from step to step the instrument goes there
// as far as tissue lets it (sim/tool/followed_place.h). It goes along tissue that is crushed, or waits there
// (sim/contact/tissue/kept_back.h). Until it is first moved, it stays on its path.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>

#include "app/session/session.h"
#include "sim/contact/tissue/tissue_cover.h"

namespace fascia {

class InstrumentHand {
 public:
  struct Picture {
    int width, height;
  };
  enum class Drag { none, shift, turn };  // in the plane of the picture; about its axes

  std::optional<std::size_t> picked() const { return picked_; }  // tool of the model
  /// The one before stays where it is.
  void pick(std::optional<std::size_t> tool);
  void pick_next(const Simulation& simulation);  // after the last one: none
  /// The instrument that is seen at this pixel.
  static std::optional<std::size_t> at(const Eigen::Vector2d& pixel, Picture picture, Session& session);

  void press(Drag drag, const Eigen::Vector2d& at);
  void move(const Eigen::Vector2d& at, Picture picture, const Session& session);
  void release() { drag_ = Drag::none; }
  bool dragging() const { return drag_ != Drag::none; }
  void scroll(double notches, const Session& session);  // away from the viewer
  /// They then close (1) or open (0), from one to the other within two seconds, until they are stopped.
  void move_jaws(double grip, const Session& session);
  void stop_jaws(const Session& session);
  bool commands() const { return commanded_.has_value(); }

  /// Before every step: leads the instrument on.
  void lead(Session& session);
  /// The state or the model has changed in another way than by a step: the instrument stays where it is.
  void rest();

  std::optional<ToolPlace> commanded() const;
  double gap(const Session& session) const;  // [m] the way of its farthest point to where it is commanded
  bool waits() const { return waits_; }      // at tissue that is crushed, as of the last step

 private:
  LedPlace& command(const Session& session);
  void stay(Simulation& simulation, const ToolPlace& now);

  std::optional<std::size_t> picked_;
  std::optional<LedPlace> commanded_;
  std::optional<double> grip_;  // to which the jaws go
  Drag drag_ = Drag::none;
  bool waits_ = false;
  Eigen::Vector2d last_{0, 0};
  std::unique_ptr<TissueCover> cover_;  // for the tool, from the first step in which it is needed
};

}  // namespace fascia
