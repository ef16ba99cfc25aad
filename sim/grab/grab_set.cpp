#include "sim/grab/grab_set.h"

namespace fascia {

bool GrabSet::take(const Model& model, const VisualSurface& surface, std::span<const Eigen::Vector3d> positions,
                   const Hit& hit, double scene_radius, const GrabSettings& settings) {
  Grab grab;
  if (!grab.take(model, surface, positions, hit, scene_radius, settings)) return false;
  grabs_.push_back({next_id_, std::move(grab)});
  next_id_ = (next_id_ + 1) % kFirstScriptedGrab;  // unique, because forces are observed a frame late
  following_ = grabs_.size() - 1;
  return true;
}

void GrabSet::take_up(std::size_t index) {
  following_ = index;
  grabs_[index].grab.plane_here();
}

void GrabSet::let_go(std::size_t index) {
  grabs_.erase(grabs_.begin() + static_cast<std::ptrdiff_t>(index));
  if (!following_) return;
  if (*following_ == index)
    following_.reset();
  else if (*following_ > index)
    --*following_;
}

void GrabSet::let_go_following() {
  if (following_) let_go(*following_);
}

std::vector<GrabSpring> GrabSet::springs(double time_step) {
  std::vector<GrabSpring> all;
  for (Entry& entry : grabs_) {
    const std::vector<GrabSpring> springs = entry.grab.springs(time_step, entry.id);
    all.insert(all.end(), springs.begin(), springs.end());
  }
  return all;
}

void GrabSet::observe(const std::vector<GrabForce>& forces) {
  for (Entry& entry : grabs_)
    for (const GrabForce& f : forces)
      if (f.grab == entry.id) entry.grab.observe(f.force);
}

std::vector<ScriptedGrab> GrabSet::staying(const Model& model) const {
  std::vector<ScriptedGrab> scripted;
  for (std::size_t i = 0; i < grabs_.size(); ++i)
    if (!follows(i)) scripted.push_back(grabs_[i].grab.as_scripted(model));
  return scripted;
}

}  // namespace fascia
