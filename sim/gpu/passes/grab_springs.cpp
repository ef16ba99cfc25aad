#include "sim/gpu/passes/grab_springs.h"

#include <algorithm>
#include <numeric>

namespace fascia {

using shared::vec4;

namespace {

// Uploads values[i] to vertices[i], and zeros between close ones. A drag does so in every step, and single uploads
// would be one copy each on the GPU.
void upload_spans(gl::Buffer& to, const std::vector<std::uint32_t>& vertices, const std::vector<vec4>& values) {
  constexpr std::uint32_t kNear = 1024;
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return vertices[a] < vertices[b]; });
  std::vector<vec4> span;
  for (std::size_t k = 0; k < order.size();) {
    const std::uint32_t first = vertices[order[k]];
    std::uint32_t last = first;
    span.clear();
    for (; k < order.size() && vertices[order[k]] - last <= kNear; ++k) {
      last = vertices[order[k]];
      span.resize(last - first + 1);
      span.back() = values[order[k]];
    }
    to.upload(first * sizeof(vec4), span.size() * sizeof(vec4), span.data());
  }
}

}  // namespace

bool GrabSprings::set(const std::vector<GrabSpring>& springs) {
  owners_.springs = springs;
  owners_.joined = joined(springs, owners_.place);
  std::vector<std::uint32_t> vertices;
  std::vector<vec4> targets;
  for (const GrabSpring& s : owners_.joined) {
    vertices.push_back(s.vertex);
    targets.push_back({static_cast<float>(s.target.x()), static_cast<float>(s.target.y()),
                       static_cast<float>(s.target.z()), static_cast<float>(s.stiffness)});
  }
  springs_ = std::move(targets);
  if (vertices == vertices_) {
    if (!springs_.empty()) target_.upload(0, springs_.size() * sizeof(vec4), springs_.data());
    spread();
    return false;
  }
  if (vertex_spring_) upload_spans(vertex_spring_, vertices_, std::vector<vec4>(vertices_.size()));
  vertices_ = std::move(vertices);
  vertex_ = vertices_.empty() ? gl::Buffer() : gl::Buffer("grab_vertex", vertices_);
  target_ = springs_.empty() ? gl::Buffer() : gl::Buffer("grab_target", springs_);
  multiplier_ = springs_.empty() ? gl::Buffer() : gl::Buffer("grab_multiplier", springs_.size() * sizeof(vec4));
  spread();
  return true;
}

void GrabSprings::set_use(bool at_vertices, bool spread_wanted, std::uint32_t vertex_count) {
  at_vertices_ = at_vertices;
  spread_ = spread_wanted;
  vertex_count_ = vertex_count;
  vertex_spring_ = {};
  spread();
}

void GrabSprings::spread() {
  if (!spread_ || vertices_.empty()) {
    vertex_spring_ = {};
    return;
  }
  if (!vertex_spring_) vertex_spring_ = gl::Buffer("vertex_spring", vertex_count_ * sizeof(vec4));
  upload_spans(vertex_spring_, vertices_, springs_);
}

std::vector<VertexStiffness> GrabSprings::stiffness() const {
  std::vector<VertexStiffness> all;
  for (const GrabSpring& spring : owners_.joined) all.push_back({spring.vertex, spring.stiffness});
  return all;
}

std::vector<gl::ComputePass> GrabSprings::project(gl::ProgramCache& programs, const SimBuffers& buffers,
                                                  bool first) const {
  std::vector<gl::ComputePass> passes;
  passes
      .emplace_back(programs.compute("sim/grab/grab.comp", {{"FIRST_ITERATION", first ? "1" : "0"}}),
                    gl::ComputePass::Bindings{{"step", &buffers.step},
                                              {"grab_vertex", &vertex_},
                                              {"grab_target", &target_},
                                              {"grab_multiplier", &multiplier_},
                                              {"predicted", &buffers.predicted},
                                              {"displacement", &buffers.displacement}},
                    count())
      .loops(0);
  return passes;
}

std::vector<gl::ComputePass> GrabSprings::impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  std::vector<gl::ComputePass> passes;
  if (at_vertices_)
    passes.emplace_back(programs.compute("sim/grab/grab_measure.comp"),
                        gl::ComputePass::Bindings{{"step", &buffers.step},
                                                  {"grab_vertex", &vertex_},
                                                  {"grab_target", &target_},
                                                  {"displacement", &buffers.displacement},
                                                  {"grab_multiplier", &multiplier_}},
                        count());
  passes.emplace_back(programs.compute("sim/grab/grab_load.comp"),
                      gl::ComputePass::Bindings{{"grab_vertex", &vertex_},
                                                {"grab_multiplier", &multiplier_},
                                                {"slot_begin", &buffers.slot_begin},
                                                {"correction", &buffers.correction}},
                      count());
  return passes;
}

void GrabSprings::forget() {
  const std::vector<vec4> zero(count());
  multiplier_.upload(0, zero.size() * sizeof(vec4), zero.data());
}

}  // namespace fascia
