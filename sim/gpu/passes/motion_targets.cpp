#include "sim/gpu/passes/motion_targets.h"

#include <algorithm>
#include <map>

namespace fascia {

using shared::vec4;

MotionTargets::MotionTargets(const Model& model) : last_change_(model.end_of_motions()) {
  std::map<std::uint32_t, Source> by_vertex;
  for (std::uint32_t m = 0; m < model.motions.size(); ++m) {
    const Motion& motion = model.motions[m];
    for (std::uint32_t k = 0; k < motion.vertices.size(); ++k) by_vertex[motion.vertices[k]] = {m, k};
  }
  for (const auto& [vertex, source] : by_vertex) {
    vertices_.push_back(vertex);
    sources_.push_back(source);
  }
  if (vertices_.empty()) return;
  vertex_ = gl::Buffer("prescribed_vertex", vertices_);
  target_ = gl::Buffer("prescribed_target", vertices_.size() * sizeof(vec4));
}

void MotionTargets::upload(const Model& model, double t) {
  const double clamped = std::min(t, last_change_);
  if (empty() || clamped == uploaded_) return;
  uploaded_ = clamped;
  std::vector<vec4> targets(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Eigen::Vector3d& rest = model.rest_positions[vertices_[i]];
    const Eigen::Vector3d u = model.motions[sources_[i].motion].position(sources_[i].index, rest, t) - rest;
    targets[i] = {static_cast<float>(u.x()), static_cast<float>(u.y()), static_cast<float>(u.z()), 0};
  }
  target_.upload(0, targets.size() * sizeof(vec4), targets.data());
}

gl::ComputePass MotionTargets::pass(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  gl::ComputePass pass(
      programs.compute("sim/step/prescribe.comp"),
      {{"prescribed_vertex", &vertex_}, {"prescribed_target", &target_}, {"displacement", &buffers.displacement}},
      static_cast<std::uint32_t>(vertices_.size()));
  pass.loops(0);
  return pass;
}

}  // namespace fascia
