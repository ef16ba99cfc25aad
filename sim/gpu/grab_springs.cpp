#include "sim/gpu/grab_springs.h"

namespace fascia {

using shared::vec4;

bool GrabSprings::set(const std::vector<GrabSpring>& springs) {
  std::vector<std::uint32_t> vertices;
  std::vector<vec4> targets;
  for (const GrabSpring& s : springs) {
    vertices.push_back(s.vertex);
    targets.push_back({static_cast<float>(s.target.x()), static_cast<float>(s.target.y()),
                       static_cast<float>(s.target.z()), static_cast<float>(s.stiffness)});
  }
  if (vertices == vertices_) {
    if (!targets.empty()) target_.upload(0, targets.size() * sizeof(vec4), targets.data());
    return false;
  }
  vertices_ = std::move(vertices);
  vertex_ = vertices_.empty() ? gl::Buffer() : gl::Buffer("grab_vertex", vertices_);
  target_ = targets.empty() ? gl::Buffer() : gl::Buffer("grab_target", targets);
  multiplier_ = targets.empty() ? gl::Buffer() : gl::Buffer("grab_multiplier", targets.size() * sizeof(vec4));
  return true;
}

gl::ComputePass GrabSprings::pull(gl::ProgramCache& programs, const SimBuffers& buffers, bool first) const {
  return {programs.compute("sim/grab.comp", {{"FIRST_ITERATION", first ? "1" : "0"}}),
          {{"step", &buffers.step},
           {"grab_vertex", &vertex_},
           {"grab_target", &target_},
           {"grab_multiplier", &multiplier_},
           {"predicted", &buffers.predicted},
           {"displacement", &buffers.displacement}},
          count()};
}

gl::ComputePass GrabSprings::load(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  return {programs.compute("sim/grab_load.comp"),
          {{"grab_vertex", &vertex_},
           {"grab_multiplier", &multiplier_},
           {"slot_begin", &buffers.slot_begin},
           {"correction", &buffers.correction}},
          count()};
}

void GrabSprings::forget() {
  const std::vector<vec4> zero(count());
  multiplier_.upload(0, zero.size() * sizeof(vec4), zero.data());
}

}  // namespace fascia
