#include "sim/model/unconstrained_parts.h"

#include <numeric>

#include "base/text.h"

namespace fascia {

UnconstrainedParts unconstrained_parts(const Model& model, const std::vector<char>& held) {
  std::vector<std::uint32_t> parent(model.rest_positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root_of = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<char> used(parent.size(), 0), supported(parent.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const ElementVertices element = model.element(t);
    for (const std::uint32_t v : element) {
      parent[root_of(v)] = root_of(element[0]);
      used[v] = 1;
    }
  }
  for (std::uint32_t v = 0; v < parent.size(); ++v)
    if (held[v]) supported[root_of(v)] = 1;
  UnconstrainedParts unconstrained;
  unconstrained.part.assign(parent.size(), 0);
  std::vector<std::uint32_t> number(parent.size(), 0);  // [root]
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    if (!used[v]) continue;
    const std::uint32_t root = root_of(v);
    if (supported[root]) {
      unconstrained.held_parts += v == root;
      continue;
    }
    if (unconstrained.vertices++ == 0) unconstrained.first = v;
    if (number[root] == 0) number[root] = static_cast<std::uint32_t>(++unconstrained.parts);
    unconstrained.part[v] = number[root];
  }
  return unconstrained;
}

std::string vertex_name(const Model& model, std::uint32_t vertex) {
  for (const BodyPart& body : model.bodies)
    if (vertex >= body.vertex_begin && vertex < body.vertex_begin + body.vertex_count)
      return "vertex " + std::to_string(vertex - body.vertex_begin) + " of " + body.name;
  return "vertex " + std::to_string(vertex);
}

std::string note_of_unconstrained_parts(const Model& model) {
  if (model.gravity.isZero(0)) return "";
  std::vector<char> held = model.held();
  for (const ResolvedGrab& grab : model.grabs)
    for (const GrabSpring& spring : grab.grip) held[spring.vertex] = 1;
  const UnconstrainedParts unconstrained = unconstrained_parts(model, held);
  if (unconstrained.parts == 0 || unconstrained.held_parts == 0) return "";
  return plural(unconstrained.parts, "component") + " of " + std::to_string(unconstrained.vertices) +
         " vertices in all " + (unconstrained.parts == 1 ? "is" : "are") + " unconstrained and will fall (" +
         vertex_name(model, unconstrained.first) + "): no vertex is fixed or prescribed";
}

}  // namespace fascia
