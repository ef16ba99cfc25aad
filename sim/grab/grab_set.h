// The grabs of a user on the tissue: one follows the mouse, others stay where they were left until they are taken up
// again or released.
#pragma once
#include <optional>
#include <vector>

#include "sim/grab/interactive_grab.h"

namespace fascia {

class GrabSet {
 public:
  struct Entry {
    std::uint32_t id;  // GrabSpring::grab
    Grab grab;
  };

  /// As Grab::take, with a grab that then follows the mouse.
  bool take(const Model& model, const VisualSurface& surface, std::span<const Eigen::Vector3d> positions,
            const Hit& hit, double scene_radius, const GrabSettings& settings);
  Grab* following() { return following_ ? &grabs_[*following_].grab : nullptr; }
  void stay() { following_.reset(); }  // the one that follows the mouse stays in place
  void take_up(std::size_t index);     // the grab follows the mouse again
  void let_go(std::size_t index);
  void let_go_following();
  void let_go_all() { grabs_.clear(), following_.reset(); }

  bool empty() const { return grabs_.empty(); }
  const std::vector<Entry>& all() const { return grabs_; }
  bool follows(std::size_t index) const { return following_ == index; }

  std::vector<GrabSpring> springs(double time_step);
  std::vector<ScriptedGrab> staying(const Model& model) const;  // those that do not follow the mouse
  void observe(const std::vector<GrabForce>& forces);

 private:
  std::vector<Entry> grabs_;
  std::optional<std::size_t> following_;
  std::uint32_t next_id_ = 0;
};

}  // namespace fascia
