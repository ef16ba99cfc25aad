#include "sim/gpu/contact/free_groups.h"

#include <algorithm>
#include <numeric>

#include "sim/contact/tissue_surface.h"

namespace fascia {
FreeGroups::FreeGroups(const Model& model, const SimBuffers& buffers)
    : bodies_(buffers.vertex_count), held_(std::max<std::size_t>(model.bodies.size(), 1)), pulled_(held_) {
  const std::vector<char> held = model.held();
  const std::vector<std::uint32_t> bodies = bodies_of_vertices(model);
  for (std::size_t v = 0; v < held.size(); ++v) {
    bodies_[buffers.placement.place[v]] = bodies[v];
    held_[bodies[v]] |= held[v];
  }
  groups_ = gl::Buffer("contact_groups", std::vector<std::uint32_t>(held_.size(), kNoBody));
}

void FreeGroups::begin(const std::vector<PairRow>& pairs, const std::vector<VertexStiffness>& springs) {
  pulled_ = held_;
  for (const VertexStiffness& spring : springs) pulled_[bodies_[spring.vertex]] = 1;
  join(pairs);
}

void FreeGroups::join(const std::vector<PairRow>& pairs) {
  std::vector<std::uint32_t> first(held_.size());
  std::iota(first.begin(), first.end(), 0u);
  const auto group_of = [&](std::uint32_t body) {
    while (first[body] != body) body = first[body];
    return body;
  };
  std::vector<char> touches(held_.size()), pulled = pulled_;
  for (const PairRow& pair : pairs) {
    const std::uint32_t a = group_of(pair.bodies[0]), b = group_of(pair.bodies[1]);
    first[std::max(a, b)] = std::min(a, b);
    touches[pair.bodies[0]] = touches[pair.bodies[1]] = 1;
  }
  for (std::uint32_t body = 0; body < first.size(); ++body) pulled[group_of(body)] |= pulled_[body];
  std::vector<std::uint32_t> groups(first.size(), kNoBody);
  for (std::uint32_t body = 0; body < first.size(); ++body)
    if (touches[body] && !pulled[group_of(body)]) groups[body] = group_of(body);
  groups_.upload(0, groups.size() * sizeof(std::uint32_t), groups.data());
}

}  // namespace fascia
