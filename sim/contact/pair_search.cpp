#include "sim/contact/pair_search.h"

#include <algorithm>
#include <utility>

#include "sim/contact/contact_surface.h"

namespace fascia {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kSkin = 0.1;  // of the mean edge: wide enough for what a penalty lets in when bodies meet
// Pairs that start closer are parted by the skin in this time [s]: what parts faster than it must jumps apart. Those
// that have less than kParting of the skin left, or none, have to part faster.
constexpr double kSlowParting = 0.5, kFastParting = 1.0 / 15;
constexpr double kParting = 0.25;  // also the most in a step, of the skin
// Bodies that a scene sets on each other, nearer than the skin and hardly closing, part slowly until twice that time.
// Their skin is what they have parted by, so that no vertex beside an edge is within it, where it would stop what
// slides.
constexpr double kHardlyMoving = 0.1;  // [s] in which they may close by the skin
// Cosine of the angle by which a face that a vertex meets may face another way than any of the faces around the vertex
// would let it. Flat tissue ahead of a body that slides on it is not met by the side of that body.
constexpr double kFacing = 0.5;
// Sine of the angle between the normals at an edge, above which it can touch another one.
constexpr double kSharp = 0.005;

}  // namespace

PairSearch::PairSearch(const Model& model) : self_(model.contact.self), bodies_(model.contact.bodies) {
  if (!model.touches_tissue()) return;
  rest_ = model.rest_positions;
  held_ = model.held();
  triangles_ = tissue_boundary(model);
  edges_ = tissue_edges(model, triangles_);
  areas_ = tissue_areas(model, triangles_);
  for (std::uint32_t v = 0; v < areas_.size(); ++v)
    if (areas_[v] > 0) vertices_.push_back(v);
  body_of_ = bodies_of_vertices(model);
  sides_.resize(triangles_.size());
  std::vector<std::uint8_t> named(triangles_.size(), 0);
  double length = 0;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    length += (rest_[edges_[e].to] - rest_[edges_[e].from]).norm();
    for (const std::uint32_t side : edges_[e].sides)
      if (side != TissueEdge::kNoSide && named[side] < 3) sides_[side][named[side]++] = e;
  }
  edge_ = length / static_cast<double>(std::max<std::size_t>(edges_.size(), 1));
  skin_ = model.contact.thickness > 0 ? model.contact.thickness : kSkin * edge_;
  trees_.resize(model.bodies.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) trees_[body_of_[triangles_[t][0]]].triangles.push_back(t);
  for (BodyTree& tree : trees_) {
    std::vector<Vector3d> middles;
    for (const std::uint32_t t : tree.triangles) {
      const Triangle& v = triangles_[t];
      middles.push_back((rest_[v[0]] + rest_[v[1]] + rest_[v[2]]) / 3);
    }
    tree.tree = BoxTree(middles);
  }
  body_slots_ = std::min(kBodySlots, static_cast<std::uint32_t>(model.bodies.size()));
  first_guard_ = first_slot_of_edge(static_cast<std::uint32_t>(edges_.size()));
  slot_count_ = first_guard_ + static_cast<std::uint32_t>(vertices_.size() + edges_.size());
  materials_changed(model);
  find_set_on_each_other(model);
}

void PairSearch::find_set_on_each_other(const Model& model) {
  if (!bodies_ || model.bodies.size() < 2) return;
  std::vector<Vector3d> velocity(model.bodies.size(), Vector3d::Zero());  // of all
  for (std::uint32_t v = 0; v < rest_.size(); ++v)
    velocity[body_of_[v]] += model.initial_velocity[v] / static_cast<double>(model.bodies[body_of_[v]].vertex_count);
  const std::vector<Vector3d> still(rest_.size(), Vector3d::Zero());
  for (const PairRow& row : find(still, still, {})) {
    double gap = 0;
    for (std::size_t k = 0; k < 4; ++k) gap += row.weights[k] * row.normal.dot(rest_[row.vertices[k]]);
    const double closing = (velocity[row.bodies[1]] - velocity[row.bodies[0]]).dot(row.normal);
    if (row.bodies[0] == row.bodies[1] || gap >= skin_ || closing * kHardlyMoving >= skin_) continue;
    const auto set = set_on_each_other_.try_emplace(std::minmax(row.bodies[0], row.bodies[1]), skin_).first;
    set->second = std::max(0.0, std::min(set->second, gap));
  }
}

void PairSearch::materials_changed(const Model& model, std::span<ContactForce> memory) {
  if (empty()) return;
  penalty_ = 2 * kContactPenalty * model.contact.stiffness;  // of two sides in a row
  masses_ = lumped_masses(model);
  viscosity_ = tissue_viscosity(model);
  const std::vector<double> before = std::exchange(softness_, tissue_stiffness(model, areas_));
  for (const std::uint32_t v : vertices_) softness_[v] = 1 / softness_[v];
  for (std::uint32_t slot = 0; slot < slot_count_ && met_row(slot) < memory.size(); ++slot) {
    ContactForce& force = memory[force_row(slot)];
    if (force.normal <= 0) continue;
    const double met = met_in(memory[met_row(slot)], slot);
    const double was = softness_between(before, slot, met), is = softness_between(softness_, slot, met);
    if (is > was) soften(force, was / is);
  }
}

double PairSearch::softness_between(const std::vector<double>& softness, std::uint32_t slot, double met) const {
  const auto vertex_count = static_cast<std::uint32_t>(vertices_.size());
  const bool guards = slot >= first_guard_,
             of_edges = guards ? slot - first_guard_ >= vertex_count : slot >= first_slot_of_edge(0);
  const bool knows = met >= 1 && met <= static_cast<double>(of_edges ? edges_.size() : triangles_.size());
  const std::uint32_t other = knows ? static_cast<std::uint32_t>(met) - 1 : 0;
  if (of_edges) {
    const auto at = [&](std::uint32_t e) { return (softness[edges_[e].from] + softness[edges_[e].to]) / 2; };
    const double own = at(guards ? slot - first_guard_ - vertex_count : (slot - first_slot_of_edge(0)) / kEdgeSlots);
    return own + (knows ? at(other) : own);
  }
  const double own = softness[vertices_[guards ? slot - first_guard_ : slot / body_slots_]];
  const Triangle& t = triangles_[other];
  return own + (knows ? (softness[t[0]] + softness[t[1]] + softness[t[2]]) / 3 : own);
}

void PairSearch::place() {
  vertex_normals_.assign(rest_.size(), Vector3d::Zero());
  normals_.resize(triangles_.size());
  std::vector<AlignedBox3d> boxes(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& t = triangles_[i];
    const Vector3d twice_area = (start_[t[1]] - start_[t[0]]).cross(start_[t[2]] - start_[t[0]]);
    for (const std::uint32_t v : t) {
      vertex_normals_[v] += twice_area;
      boxes[i].extend(start_[v]).extend(end_[v]);
    }
    normals_[i] = twice_area.stableNormalized();
  }
  for (const std::uint32_t v : vertices_) vertex_normals_[v].stableNormalize();
  facing_.assign(rest_.size(), 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (const std::uint32_t v : triangles_[i]) facing_[v] = std::min(facing_[v], normals_[i].dot(vertex_normals_[v]));
  for (const std::uint32_t v : vertices_) {
    const double c = facing_[v], s = std::sqrt(std::max(0.0, 1 - c * c));
    facing_[v] = std::max(0.0, kFacing * c - std::sqrt(1 - kFacing * kFacing) * s);
  }
  convex_.resize(edges_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const TissueEdge& edge = edges_[e];
    convex_[e] = 0;
    if (edge.sides[1] == TissueEdge::kNoSide) continue;
    const Triangle& first = triangles_[edge.sides[0]];
    const std::uint32_t opposite = first[0] + first[1] + first[2] - edge.from - edge.to;
    const Vector3d &a = normals_[edge.sides[0]], &b = normals_[edge.sides[1]];
    if (edge_pressed(static_cast<std::uint32_t>(e))) {
      convex_[e] = 1;
      continue;
    }
    convex_[e] = a.cross(b).squaredNorm() > kSharp * kSharp && b.dot(start_[opposite] - start_[edge.from]) < 0;
  }
  for (std::uint32_t slot = first_slot_of_edge(0); slot < first_guard_; ++slot)
    if (pressed_[slot] && met_[slot] > 0 && met_[slot] <= edges_.size())
      convex_[met_[slot] - 1] = edges_[met_[slot] - 1].sides[1] != TissueEdge::kNoSide;
  fit_trees(boxes, facings());
}

// Around the normal of each triangle, and around those at the edges that are met from it.
std::vector<AlignedBox3d> PairSearch::facings() const {
  std::vector<AlignedBox3d> facings;
  facings.reserve(triangles_.size());
  for (const Vector3d& normal : normals_) facings.emplace_back(normal);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (convex_[e]) facings[edges_[e].sides[0]].extend(normal_sum(edges_[e]));
  return facings;
}

void PairSearch::fit_trees(const std::vector<AlignedBox3d>& boxes, const std::vector<AlignedBox3d>& facings) {
  std::vector<AlignedBox3d> own, own_facings;
  for (BodyTree& tree : trees_) {
    own.clear();
    own_facings.clear();
    for (const std::uint32_t t : tree.triangles) own.push_back(boxes[t]);
    for (std::size_t k = 0; k < tree.triangles.size() && !facings.empty(); ++k)
      own_facings.push_back(facings[tree.triangles[k]]);
    tree.tree.fit(own, own_facings);
  }
}

std::vector<char> PairSearch::carried(std::span<const ContactForce> before, double time) const {
  std::vector<char> bodies(trees_.size(), 0), carried(rest_.size(), 0);
  if (time == 0)
    for (const auto& set : set_on_each_other_) bodies[set.first.first] = bodies[set.first.second] = 1;
  for (std::uint32_t slot = 0; slot < first_guard_ && met_row(slot) < before.size(); ++slot) {
    if (before[force_row(slot)].normal <= 0) continue;
    ContactForce row = before[met_row(slot)];
    const double met = met_in(row, slot);
    const bool of_edge = slot >= first_slot_of_edge(0);
    if (met < 1 || met > static_cast<double>(of_edge ? edges_.size() : triangles_.size())) continue;
    const auto other = static_cast<std::size_t>(met) - 1;
    const std::uint32_t a = of_edge ? edges_[(slot - first_slot_of_edge(0)) / kEdgeSlots].from
                                    : vertices_[slot / body_slots_],
                        b = of_edge ? edges_[other].from : triangles_[other][0];
    if (body_of_[a] != body_of_[b]) bodies[body_of_[a]] = bodies[body_of_[b]] = 1;
  }
  for (std::size_t v = 0; v < carried.size(); ++v) carried[v] = bodies[body_of_[v]];
  return carried;
}

std::vector<PairRow> PairSearch::find(const std::vector<Vector3d>& start, const std::vector<Vector3d>& end,
                                      std::span<const ContactForce> before, double length, double time) {
  cuts_ = false;
  length_ = length;
  time_ = time;
  if (empty()) return {};
  normal_.assign(slot_count_, 0);
  pressed_.assign(slot_count_, 0);
  met_.assign(slot_count_, 0);
  for (std::uint32_t slot = 0; slot < slot_count_ && met_row(slot) < before.size(); ++slot) {
    normal_[slot] = before[force_row(slot)].normal;
    pressed_[slot] = normal_[slot] > 0;
    ContactForce met = before[met_row(slot)];
    met_[slot] = static_cast<std::uint32_t>(std::clamp(met_in(met, slot), 0.0, 1e9));
  }
  start_.resize(rest_.size());
  end_.resize(rest_.size());
  for (const std::uint32_t v : vertices_) {
    start_[v] = rest_[v] + start[v];
    end_[v] = rest_[v] + end[v];
  }
  near_.assign(rest_.size(), 0);
  place();
  keep_guards();
  return find_pairs();
}

// Of each side that between its vertices: beyond them it would be below 0 where softnesses differ.
double PairSearch::softness_of(const PairRow& row) const {
  std::array<double, 2> softness{}, weight{};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t side = row.sides[k];
    const double share = std::max(0.0, side == 0 ? row.weights[k] : -row.weights[k]);
    softness[side] += share * softness_[row.vertices[k]];
    weight[side] += share;
  }
  return softness[0] / weight[0] + softness[1] / weight[1];
}

double PairSearch::stage_stiffness_of(const PairRow& row) const {
  double mobility = 0, ratio = 0;  // [1/kg], [s]
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t v = row.vertices[k];
    if (held_[v]) continue;
    mobility += row.weights[k] * row.weights[k] / masses_[v];
    ratio = std::max(ratio, viscosity_[v]);
  }
  return stage_stiffness(row.stiffness, 1 / mobility, ratio * row.stiffness / penalty_, length_);
}

double PairSearch::skin_between(std::uint32_t a, std::uint32_t b) const {
  if (time_ >= 2 * kSlowParting) return skin_;
  const auto set = set_on_each_other_.find(std::minmax(a, b));
  if (set == set_on_each_other_.end()) return skin_;
  return std::min(skin_, set->second + (time_ + length_) / kSlowParting * skin_);
}

double PairSearch::target_of(const PairRow& row, double gap) const {
  const double slow = std::min(kParting, length_ / kSlowParting), fast = std::min(kParting, length_ / kFastParting);
  const bool calm = time_ < 2 * kSlowParting && set_on_each_other_.contains(std::minmax(row.bodies[0], row.bodies[1]));
  const double danger = calm ? 0 : std::clamp(1 - gap / (kParting * skin_), 0.0, 1.0);
  return std::min(skin_between(row.bodies[0], row.bodies[1]), gap + (slow + danger * (fast - slow)) * skin_);
}

std::vector<PairRow> PairSearch::find_again() {
  if (empty()) return {};
  place();
  return find_pairs();
}

std::vector<PairRow> PairSearch::find_pairs() {
  rows_.clear();
  crossings_.clear();
  cost_.assign(slot_count_, 0);
  holder_.assign(slot_count_, kNone);
  for (std::uint32_t other = 0; other < trees_.size(); ++other) {
    if (trees_[other].tree.empty()) continue;
    AlignedBox3d reach = trees_[other].tree.bounds();
    reach.extend(Vector3d(reach.min().array() - 2 * edge_)).extend(Vector3d(reach.max().array() + 2 * edge_));
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const std::uint32_t v = vertices_[i];
      if (may_touch(body_of_[v], other) && reach.intersects(AlignedBox3d(start_[v]).extend(end_[v])))
        look_at_vertex(i, other);
    }
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      if (const std::uint32_t body = body_of_[edges_[e].from];
          convex_[e] && body <= other && may_touch(body, other) &&
          reach.intersects(
              AlignedBox3d(start_[edges_[e].from]).extend(end_[edges_[e].from]).extend(start_[edges_[e].to])))
        look_at_edge(e, other);
  }
  choose_crossings();
  add_guards();
  for (PairRow& row : rows_) {
    Vector3d x(0, 0, 0);
    for (std::size_t k = 0; k < 4; ++k) {
      x += row.weights[k] * start_[row.vertices[k]];
      row.start += row.weights[k] * (start_[row.vertices[k]] - rest_[row.vertices[k]]);
    }
    row.before = normal_[row.slot];
    row.stiffness = stage_stiffness_of(row);
    const double gap = row.normal.dot(x);
    row.gap = gap - target_of(row, gap);
    for (std::size_t k = 1; k < 4 && held_[row.vertices[0]]; ++k) {  // a free vertex carries the energy
      std::swap(row.vertices[0], row.vertices[k]);
      std::swap(row.weights[0], row.weights[k]);
      std::swap(row.sides[0], row.sides[k]);
    }
  }
  std::sort(rows_.begin(), rows_.end(), [](const PairRow& a, const PairRow& b) { return a.slot < b.slot; });
  return rows_;
}

}  // namespace fascia
