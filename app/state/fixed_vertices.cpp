#include "app/state/fixed_vertices.h"

#include <algorithm>
#include <set>
#include <utility>

#include "sim/mesh/mid_edges.h"

namespace fascia {

FixedSets fixed_of(const Scene& scene) {
  FixedSets sets;
  for (const Body& body : scene.bodies) sets.push_back(body.fixed);
  return sets;
}

FixedSets with_fixed(const Scene& scene, const Model& model, std::span<const std::uint32_t> vertices, bool fix) {
  FixedSets sets = fixed_of(scene);
  std::vector<char> prescribed(model.rest_positions.size(), 0);
  for (const Motion& motion : model.motions)
    for (const std::uint32_t v : motion.vertices) prescribed[v] = 1;
  std::vector<char> follows(model.rest_positions.size(), 0);  // the ends of its edge: it is never listed
  for (const MidEdge& edge : mid_edges_of(model.file_mesh)) follows[edge.vertex] = 1;
  for (std::size_t b = 0; b < sets.size(); ++b) {
    const std::uint32_t begin = model.bodies[b].vertex_begin, end = begin + model.bodies[b].vertex_count;
    const auto inside = [&](std::uint32_t v) { return v >= begin && v < end && !follows[v]; };
    std::set<std::uint32_t> held;
    for (const std::uint32_t v : model.fixed)
      if (inside(v)) held.insert(v - begin);
    const std::set<std::uint32_t> before = held;
    for (const std::uint32_t v : vertices) {
      if (!inside(v) || prescribed[v]) continue;
      if (fix)
        held.insert(v - begin);
      else
        held.erase(v - begin);
    }
    if (held == before) continue;
    sets[b].clear();
    if (!held.empty()) sets[b].emplace_back(VertexSelection{{held.begin(), held.end()}});
  }
  return sets;
}

}  // namespace fascia
