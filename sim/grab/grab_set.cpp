#include "sim/grab/grab_set.h"

namespace fascia {

bool Hands::take(const Model& model, const DrawnSurface& surface, std::span<const Eigen::Vector3d> positions,
                 const Hit& hit, double scene_radius, const GrabSettings& settings) {
  Grab grab;
  if (!grab.take(model, surface, positions, hit, scene_radius, settings)) return false;
  hands_.push_back({next_id_, std::move(grab)});
  next_id_ = (next_id_ + 1) % kFirstScriptedHand;  // another one each time: forces are observed a frame late
  following_ = hands_.size() - 1;
  return true;
}

void Hands::take_up(std::size_t index) {
  following_ = index;
  hands_[index].grab.plane_here();
}

void Hands::let_go(std::size_t index) {
  hands_.erase(hands_.begin() + static_cast<std::ptrdiff_t>(index));
  if (!following_) return;
  if (*following_ == index)
    following_.reset();
  else if (*following_ > index)
    --*following_;
}

void Hands::let_go_following() {
  if (following_) let_go(*following_);
}

std::vector<GrabSpring> Hands::springs(double time_step) {
  std::vector<GrabSpring> all;
  for (Hand& hand : hands_) {
    const std::vector<GrabSpring> springs = hand.grab.springs(time_step, hand.id);
    all.insert(all.end(), springs.begin(), springs.end());
  }
  return all;
}

void Hands::observe(const std::vector<HandForce>& forces) {
  for (Hand& hand : hands_)
    for (const HandForce& f : forces)
      if (f.hand == hand.id) hand.grab.observe(f.force);
}

}  // namespace fascia
