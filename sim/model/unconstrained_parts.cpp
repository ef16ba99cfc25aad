#include "sim/model/unconstrained_parts.h"

#include <numeric>

#include "base/text.h"

namespace fascia {

LooseParts loose_parts(const Model& model, const std::vector<char>& held) {
  std::vector<std::uint32_t> parent(model.rest_positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root_of = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<char> used(parent.size(), 0), supported(parent.size(), 0);
  for (const Tet& tet : model.tets) {
    for (const std::uint32_t v : tet) {
      parent[root_of(v)] = root_of(tet[0]);
      used[v] = 1;
    }
  }
  for (std::uint32_t v = 0; v < parent.size(); ++v)
    if (held[v]) supported[root_of(v)] = 1;
  LooseParts loose;
  loose.loose.assign(parent.size(), 0);
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    if (!used[v]) continue;
    const std::uint32_t root = root_of(v);
    if (supported[root]) {
      loose.held_parts += v == root;
      continue;
    }
    if (loose.vertices++ == 0) loose.first = v;
    loose.loose[v] = 1;
    loose.parts += v == root;
  }
  return loose;
}

std::string vertex_name(const Model& model, std::uint32_t vertex) {
  for (const BodyPart& body : model.bodies)
    if (vertex >= body.vertex_begin && vertex < body.vertex_begin + body.vertex_count)
      return "vertex " + std::to_string(vertex - body.vertex_begin) + " of " + body.name;
  return "vertex " + std::to_string(vertex);
}

std::string note_of_loose_parts(const Model& model) {
  if (model.gravity.isZero(0)) return "";
  std::vector<char> held = model.held();
  for (const ScriptedHand& hand : model.hands)
    for (const GrabSpring& spring : hand.grip) held[spring.vertex] = 1;
  const LooseParts loose = loose_parts(model, held);
  if (loose.parts == 0 || loose.held_parts == 0) return "";
  return plural(loose.parts, "part") + " of " + std::to_string(loose.vertices) + " vertices in all " +
         (loose.parts == 1 ? "is" : "are") + " held nowhere and will fall (" + vertex_name(model, loose.first) +
         "): no vertex shared with what is fixed or prescribed";
}

}  // namespace fascia
