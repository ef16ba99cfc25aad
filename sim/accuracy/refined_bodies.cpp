#include "sim/accuracy/refined_bodies.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "sim/accuracy/refined_model.h"
#include "sim/elements/quadratic_tet.h"
#include "sim/mesh/linear_tets.h"
#include "sim/mesh/mid_edges.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int kFree = -2, kFixed = -1;  // else an index into Model::motions

template <std::size_t n>
std::array<std::uint32_t, n> shifted(std::array<std::uint32_t, n> vertices, std::uint32_t by) {
  for (std::uint32_t& vertex : vertices) vertex += by;
  return vertices;
}

class Refinement {
 public:
  explicit Refinement(const Model& coarse) : coarse_(coarse) {
    Model& fine = result_.model;
    fine.materials = coarse.materials;
    fine.material_names = coarse.material_names;
    fine.tools = coarse.tools;
    fine.contact = coarse.contact;
    fine.gravity = coarse.gravity;
    fine.surfaces.resize(coarse.bodies.size());
    result_.places.resize(coarse.rest_positions.size());
    for (const BodyPart& body : coarse.bodies) add(body);
    hold();
    name_groups();
    fine.rest_positions = fine.file_mesh.positions;
    fine.tets = fine.file_mesh.tets;
    fine.mid_edges = fine.file_mesh.mid_edges;
    fine.tet_source.resize(fine.tets.size());
    std::iota(fine.tet_source.begin(), fine.tet_source.end(), 0u);
  }

  RefinedBodies take() { return std::move(result_); }

 private:
  // A new vertex: the ends of its edge, and its place in a coarse tet.
  struct Middle {
    std::uint32_t vertex, a, b;
    std::uint32_t tet;
    Vector4d at;
  };

  void add(const BodyPart& body) {
    TetMesh own;
    const auto first = coarse_.rest_positions.begin() + body.vertex_begin;
    own.positions.assign(first, first + body.vertex_count);
    std::vector<std::uint32_t> parents;
    Model& fine = result_.model;
    for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t) {
      const Tet corners = shifted(coarse_.tets[t], 0u - body.vertex_begin);
      if (coarse_.is_quadratic(t)) {
        const MidEdges middles = shifted(coarse_.mid_edges[t], 0u - body.vertex_begin);
        for (const Tet& part : cut_in_eight(corners, middles, own.positions)) own.tets.push_back(part);
      } else {
        own.tets.push_back(corners);
      }
      parents.resize(own.tets.size(), t);
    }
    std::vector<std::uint32_t> all(own.tets.size());
    std::iota(all.begin(), all.end(), 0u);
    add_mid_edges(own, all);

    TetMesh& whole = fine.file_mesh;
    BodyPart part = body;
    part.vertex_begin = static_cast<std::uint32_t>(whole.positions.size());
    part.vertex_count = static_cast<std::uint32_t>(own.positions.size());
    part.tet_begin = static_cast<std::uint32_t>(whole.tets.size());
    part.tet_count = static_cast<std::uint32_t>(own.tets.size());
    for (std::uint32_t v = 0; v < body.vertex_count; ++v) result_.places[body.vertex_begin + v] = part.vertex_begin + v;
    whole.positions.insert(whole.positions.end(), own.positions.begin(), own.positions.end());
    std::vector<char> seen(own.positions.size(), 0);
    for (std::size_t s = 0; s < own.tets.size(); ++s) {
      const std::uint32_t parent = parents[s];
      fine.tet_material.push_back(coarse_.tet_material[parent]);
      whole.regions.push_back(coarse_.file_mesh.regions[coarse_.tet_source[parent]]);
      whole.tets.push_back(shifted(own.tets[s], part.vertex_begin));
      whole.mid_edges.push_back(shifted(own.mid_edges[s], part.vertex_begin));
      const ElementVertices element = coarse_.element(parent);
      for (std::size_t m = 0; m < 6; ++m) {
        const std::uint32_t v = own.mid_edges[s][m];
        if (seen[v] != 0) continue;
        seen[v] = 1;
        const auto [a, b] = kMidEdgeCorners[m];
        const std::uint32_t ends[] = {own.tets[s][a], own.tets[s][b]};
        middles_.push_back(
            {part.vertex_begin + v, body.vertex_begin + ends[0], body.vertex_begin + ends[1], parent,
             0.5 * (place_in(element, body.vertex_begin + ends[0]) + place_in(element, body.vertex_begin + ends[1]))});
      }
    }
    fine.bodies.push_back(std::move(part));
  }

  Vector3d value_at(const Middle& middle, const std::vector<Vector3d>& of) const {
    const ElementVertices element = coarse_.element(middle.tet);
    Vector3d sum = Vector3d::Zero();
    if (element.size() == 4) {
      for (int n = 0; n < 4; ++n) sum += middle.at[n] * of[element[static_cast<std::size_t>(n)]];
    } else {
      const QuadraticTet::ShapeFunctions values = QuadraticTet::shape_functions(middle.at);
      for (std::size_t n = 0; n < 10; ++n) sum += values[n] * of[element[n]];
    }
    return sum;
  }

  void hold() {
    Model& fine = result_.model;
    std::vector<int> holder(coarse_.rest_positions.size(), kFree);
    for (const std::uint32_t v : coarse_.fixed) holder[v] = kFixed;
    std::vector<Vector3d> target(coarse_.rest_positions.size(), Vector3d::Zero());
    for (std::size_t m = 0; m < coarse_.motions.size(); ++m) {
      Motion& motion = fine.motions.emplace_back(coarse_.motions[m]);
      for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
        std::uint32_t& v = motion.vertices[k];
        holder[v] = static_cast<int>(m);
        if (!motion.targets.empty()) target[v] = motion.targets[k];
        v = result_.places[v];
      }
    }
    for (const std::uint32_t v : coarse_.fixed) fine.fixed.push_back(result_.places[v]);
    fine.initial_velocity.resize(fine.file_mesh.positions.size(), Vector3d::Zero());
    for (std::size_t v = 0; v < result_.places.size(); ++v)
      fine.initial_velocity[result_.places[v]] = coarse_.initial_velocity[v];
    for (const Middle& middle : middles_) {
      if (holder[middle.a] == kFree || holder[middle.a] != holder[middle.b]) {
        fine.initial_velocity[middle.vertex] = value_at(middle, coarse_.initial_velocity);
      } else if (holder[middle.a] == kFixed) {
        fine.fixed.push_back(middle.vertex);
      } else {
        Motion& motion = fine.motions[static_cast<std::size_t>(holder[middle.a])];
        motion.vertices.push_back(middle.vertex);
        if (!motion.targets.empty()) motion.targets.push_back(value_at(middle, target));
      }
    }
    std::sort(fine.fixed.begin(), fine.fixed.end());
  }

  // With the mid-edge vertices between vertices of the group, which a file of linear tets does not name.
  void name_groups() {
    TetMesh& whole = result_.model.file_mesh;
    whole.region_names = coarse_.file_mesh.region_names;
    const std::vector<MidEdge> edges = mid_edges_of(coarse_.file_mesh);
    for (const auto& [name, vertices] : coarse_.file_mesh.groups) {
      const std::set<std::uint32_t> given(vertices.begin(), vertices.end());
      std::set<std::uint32_t> all;
      for (const std::uint32_t v : given) all.insert(result_.places[v]);
      for (const MidEdge& edge : edges)
        if (given.contains(edge.a) && given.contains(edge.b)) all.insert(result_.places[edge.vertex]);
      whole.groups[name].assign(all.begin(), all.end());
    }
  }

  const Model& coarse_;
  RefinedBodies result_;
  std::vector<Middle> middles_;
};

}  // namespace

RefinedBodies refined_bodies(const Model& coarse) { return Refinement(coarse).take(); }

}  // namespace fascia
