// Guards of a step: pairs that keep apart what went through each other in an earlier solution of the step, whatever
// their normals say. They stay while they press. Where all of them are in vain, bodies are taken back.
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/contact/pair_search.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vertices = std::array<std::uint32_t, 4>;

// Of the skin: pairs whose gap is less at the end, and that were pressed in by more, press harder in the next solution.
constexpr double kLeastGap = 0.25;
constexpr double kPressedIn = 0.2;
constexpr double kTouching = 1e-3;
// Cosines: of the angle by which the normal at an edge turns in a step, and of that between it and the way.
constexpr double kTurned = 0.94;
constexpr double kAgainst = 0.1;

Vertices sorted(Vertices vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

bool of_edges(const PairRow& row) { return std::count(row.sides.begin(), row.sides.end(), 1) == 2; }

bool same_features(const PairRow& a, const PairRow& b) {
  return of_edges(a) == of_edges(b) && sorted(a.vertices) == sorted(b.vertices);
}

std::array<Vector3d, 4> at(const std::vector<Vector3d>& x, const Vertices& v) {
  return {x[v[0]], x[v[1]], x[v[2]], x[v[3]]};
}

AlignedBox3d around(const AlignedBox3d& box, double reach) {
  return {box.min().array() - reach, box.max().array() + reach};
}

}  // namespace

// Calls found(triangle) for those of the body that the edge goes through.
template <class F>
void PairSearch::for_cuts(std::uint32_t e, std::uint32_t body, const std::vector<Vector3d>& x, F&& found) const {
  const TissueEdge& edge = edges_[e];
  trees_[body].tree.for_overlaps(AlignedBox3d(x[edge.from]).extend(x[edge.to]), [&](std::uint32_t k) {
    const std::uint32_t triangle = trees_[body].triangles[k];
    const Triangle& t = triangles_[triangle];
    const auto has = [&](std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
    if (!has(edge.from) && !has(edge.to) && goes_through(x[edge.from], x[edge.to], x[t[0]], x[t[1]], x[t[2]]))
      found(triangle);
  });
}

std::uint32_t PairSearch::guard_of_vertex(std::uint32_t vertex) const {
  const auto place = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
  return first_guard_ + static_cast<std::uint32_t>(place - vertices_.begin());
}

bool PairSearch::all_held(const Vertices& v) const { return held_[v[0]] && held_[v[1]] && held_[v[2]] && held_[v[3]]; }

double PairSearch::depth_of(const PairRow& row) const {
  double depth = -row.gap;
  for (std::size_t k = 0; k < 4; ++k)
    depth -= row.weights[k] * row.normal.dot(end_[row.vertices[k]] - start_[row.vertices[k]]);
  return depth;
}

bool PairSearch::press_harder(const PairRow& row) {
  raised_[row.slot] = 1;
  normal_[row.slot] += row.stiffness * std::max(depth_of(row), kLeastGap * skin_);
  return true;
}

// Whether the next solution differs by it: a new guard, one with another normal, or a pair that presses harder.
bool PairSearch::add_guard(const Passage& passage, const Vertices& vertices, const PairRow::Sides& sides, double area,
                           std::initializer_list<std::uint32_t> slots) {
  PairRow row;
  row.vertices = vertices;
  row.sides = sides;
  row.weights = passage.weights;
  row.normal = passage.normal;
  row.bodies = {body_of_[vertices[0]], body_of_[vertices[3]]};
  Vector3d at_rest(0, 0, 0);
  for (std::size_t k = 0; k < 4; ++k) at_rest += row.weights[k] * rest_[vertices[k]];
  if (row.bodies[0] == row.bodies[1] && at_rest.norm() < 2 * skin_) return false;
  row.stiffness = penalty_ * area / softness_of(row);
  const auto same = [&](const PairRow& other) { return same_features(other, row); };
  const auto known = std::find_if(rows_.begin(), rows_.end(), same);
  if (known != rows_.end()) {
    if (raised_[known->slot]) return false;
    if (depth_of(*known) > 0) return press_harder(*known);
  }
  if (const auto guard = std::find_if(guards_.begin(), guards_.end(), same); guard != guards_.end()) {
    if (known == rows_.end() || guard->normal == row.normal) return false;  // of this search
    row.slot = guard->slot;
    *guard = row;
    return true;
  }
  auto place = guards_.end();
  for (const std::uint32_t slot : slots) {
    row.slot = slot;
    place = std::find_if(guards_.begin(), guards_.end(), [&](const PairRow& guard) { return guard.slot == slot; });
    if (place == guards_.end()) break;
  }
  if (place == guards_.end())
    guards_.push_back(row);
  else
    *place = row;
  return true;
}

// Guards what the edge and the triangle first went through each other by.
bool PairSearch::guard(std::uint32_t e, std::uint32_t triangle) {
  const Triangle& t = triangles_[triangle];
  const TissueEdge& edge = edges_[e];
  std::optional<Passage> first;
  Vertices vertices{};
  std::uint32_t other_edge = kNone;
  const auto consider = [&](const std::optional<Passage>& passage, const Vertices& of, std::uint32_t other) {
    if (!passage || (first && first->share <= passage->share) || all_held(of)) return;
    first = passage;
    vertices = of;
    other_edge = other;
  };
  for (const std::uint32_t v : {edge.from, edge.to}) {
    const Vertices of{v, t[0], t[1], t[2]};
    consider(vertex_through_triangle(at(start_, of), at(end_, of)), of, kNone);
  }
  for (const std::uint32_t other : sides_[triangle]) {
    const Vertices of{edge.from, edge.to, edges_[other].from, edges_[other].to};
    consider(edge_through_edge(at(start_, of), at(end_, of)), of, other);
  }
  if (!first) return false;
  if (other_edge == kNone)
    return add_guard(*first, vertices, PairRow::kOfVertex, areas_[vertices[0]], {guard_of_vertex(vertices[0])});
  return add_guard(*first, vertices, PairRow::kOfEdges, (edge.area + edges_[other_edge].area) / 6,
                   {guard_of_edge(e), guard_of_edge(other_edge)});
}

void PairSearch::look_at(const std::vector<Vector3d>& end) {
  std::vector<AlignedBox3d> boxes(triangles_.size());
  for (const std::uint32_t v : vertices_) end_[v] = rest_[v] + end[v];
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (const std::uint32_t v : triangles_[i]) boxes[i].extend(end_[v]);
  fit_trees(boxes, {});
}

// Whether an edge began inside another body, in whole or in part: it may leave.
bool PairSearch::began_inside(const TissueEdge& edge, std::uint32_t body) const {
  const Vector3d &from = start_[edge.from], &to = start_[edge.to];
  const Vector3d far = from + 1e3 * edge_ * Vector3d(0.531, 0.647, 0.547);
  int passed = 0;
  for (const std::uint32_t k : trees_[body].triangles) {
    const Triangle& t = triangles_[k];
    if (goes_through(from, to, start_[t[0]], start_[t[1]], start_[t[2]])) return true;
    passed += goes_through(from, far, start_[t[0]], start_[t[1]], start_[t[2]]);
  }
  return passed % 2 != 0;
}

// What touches at the start, as faces that a scene sets on each other without a gap, is on no side yet.
template <class F>
void PairSearch::for_new_cuts(F&& found) const {
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const TissueEdge& edge = edges_[e];
    const std::uint32_t own = body_of_[edge.from];
    const bool near = near_[edge.from] || near_[edge.to];  // what deforms most may go through where no pair was seen
    for (std::uint32_t body = 0; body < trees_.size(); ++body)
      if (may_touch(own, body) && (near || body != own))
        for_cuts(e, body, end_, [&](std::uint32_t triangle) {
          const Triangle& t = triangles_[triangle];
          if (goes_through(start_[edge.from], start_[edge.to], start_[t[0]], start_[t[1]], start_[t[2]])) return;
          if (distance_to_triangle({start_[edge.from], start_[edge.to]}, at_start(t)) < kTouching * skin_) return;
          if (body == own || !began_inside(edge, body)) found(e, triangle);
        });
  }
}

// Whether a vertex that an edge presses against its way has gone so far around it that the normal is another one.
bool PairSearch::turned(const PairRow& row) const {
  const bool of_vertex = row.weights[0] == 1 && row.weights[1] <= 0 && row.weights[2] <= 0 && row.weights[3] <= 0;
  if (!of_vertex || (row.weights[1] < 0 && row.weights[2] < 0 && row.weights[3] < 0)) return false;
  Vector3d way(0, 0, 0);
  for (std::size_t k = 0; k < 4; ++k) way += row.weights[k] * (end_[row.vertices[k]] - start_[row.vertices[k]]);
  if (!(depth_of(row) > 0) || !(row.normal.dot(way) < -kAgainst * way.norm())) return false;
  const std::array<Vector3d, 4> x = at(end_, row.vertices);
  const Vector3d w = nearest_weights(x[0], x[1], x[2], x[3]), between = x[0] - w[0] * x[1] - w[1] * x[2] - w[2] * x[3];
  return between.norm() > kGrazed * skin_ && between.dot(row.normal) < kTurned * between.norm();
}

bool PairSearch::misses(const std::vector<Vector3d>& end) {
  cuts_ = false;
  if (empty() || !sees_near()) return false;
  look_at(end);
  bool changed = false;
  raised_.assign(slot_count_, 0);
  for (const PairRow& row : rows_) {
    double gap = 0;
    for (std::size_t k = 0; k < 4; ++k) gap += row.weights[k] * row.normal.dot(end_[row.vertices[k]]);
    if (gap < kLeastGap * skin_ && depth_of(row) > kPressedIn * skin_) changed = press_harder(row);
    changed = changed || turned(row);
  }
  for_new_cuts([&](std::uint32_t e, std::uint32_t triangle) {
    cuts_ = true;
    changed |= guard(e, triangle);
  });
  return changed;
}

// Of bodies as if they were one rigid body, from their places at the start of the step.
struct PairSearch::Together {
  double mass = 0;
  Vector3d center{0, 0, 0}, way{0, 0, 0}, angular{0, 0, 0};  // way of the center [m]; angular: of ways [kg m^2]
  Matrix3d turning = Matrix3d::Zero(), turn = Matrix3d::Identity();

  Vector3d way_of(const Vector3d& place) const { return way + turn * (place - center) - (place - center); }
};

std::vector<PairSearch::Together> PairSearch::together(const std::vector<std::uint32_t>& leaders,
                                                       const std::vector<Vector3d>& start,
                                                       const std::vector<Vector3d>& end,
                                                       const std::vector<double>& masses) const {
  std::vector<Together> groups(leaders.size());
  const auto group_of = [&](std::size_t v) -> Together& { return groups[leaders[body_of_[v]]]; };
  for (std::size_t v = 0; v < start.size(); ++v) group_of(v).mass += masses[v];
  for (std::size_t v = 0; v < start.size(); ++v) {
    const double share = masses[v] / group_of(v).mass;
    group_of(v).center += share * (rest_[v] + start[v]);
    group_of(v).way += share * (end[v] - start[v]);
  }
  for (std::size_t v = 0; v < start.size(); ++v) {
    const Vector3d arm = rest_[v] + start[v] - group_of(v).center;
    group_of(v).angular += masses[v] * arm.cross(end[v] - start[v]);
    group_of(v).turning += masses[v] * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
  }
  for (Together& group : groups) {
    const Vector3d turn = group.turning.ldlt().solve(group.angular);
    if (const double angle = turn.norm(); angle > 0 && std::isfinite(angle))
      group.turn = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  }
  return groups;
}

std::optional<std::vector<Vector3d>> PairSearch::taken_back(const std::vector<Vector3d>& start,
                                                            const std::vector<Vector3d>& end,
                                                            const std::vector<double>& masses) {
  constexpr double kLeastShare = 1.0 / 16;
  if (empty() || !sees_near()) return std::nullopt;
  struct Group {  // of bodies, by its first one
    double share = 1;
    bool held = false, in_vain = false;
  };
  std::vector<Group> groups(trees_.size());
  std::vector<std::uint32_t> leaders(trees_.size());
  std::iota(leaders.begin(), leaders.end(), 0u);
  for (std::size_t v = 0; v < start.size(); ++v) groups[body_of_[v]].held |= held_[v] != 0;
  const auto leader_of = [&](std::uint32_t body) {
    while (leaders[body] != body) body = leaders[body];
    return body;
  };
  std::vector<Vector3d> result = end;
  for (;;) {
    std::vector<char> cut(groups.size(), 0);
    look_at(result);
    for_new_cuts([&](std::uint32_t e, std::uint32_t triangle) {
      const std::uint32_t a = leader_of(body_of_[edges_[e].from]), b = leader_of(body_of_[triangles_[triangle][0]]);
      Group &first = groups[std::min(a, b)], &second = groups[std::max(a, b)];
      if (a != b) {
        leaders[std::max(a, b)] = std::min(a, b);
        first = {std::min(first.share, second.share), first.held || second.held, first.in_vain || second.in_vain};
        if (first.in_vain) first.share = 1;
        cut[std::max(a, b)] = 0;
      }
      cut[std::min(a, b)] = 1;
    });
    bool changed = false;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      Group& group = groups[g];
      if (!cut[g] || group.in_vain) continue;
      group.in_vain = group.share == 0;  // as where a script moves one body through another
      group.share = group.in_vain ? 1 : group.share > kLeastShare ? group.share / 2 : 0;
      changed = true;
    }
    if (!changed) return result == end ? std::nullopt : std::optional(result);
    std::vector<std::uint32_t> of_body(leaders.size());
    for (std::uint32_t body = 0; body < leaders.size(); ++body) of_body[body] = leader_of(body);
    const std::vector<Together> whole = together(of_body, start, end, masses);
    for (std::size_t v = 0; v < result.size(); ++v) {
      const std::uint32_t leader = of_body[body_of_[v]];
      const Group& group = groups[leader];
      result[v] = end[v];
      if (held_[v] || group.share == 1) continue;
      const Vector3d way = group.held ? Vector3d(0, 0, 0) : whole[leader].way_of(rest_[v] + start[v]);
      result[v] = start[v] + group.share * (end[v] - start[v]) + (1 - group.share) * way;
    }
  }
}

void PairSearch::slow_down(const std::vector<Vector3d>& start, const std::vector<Vector3d>& end,
                           const std::vector<Vector3d>& back, double duration, std::vector<Vector3d>& velocity) {
  for (std::size_t v = 0; v < back.size(); ++v)
    if (back[v] != end[v]) velocity[v] = (back[v] - start[v]) / duration;
}

bool PairSearch::take_back(const std::vector<Vector3d>& start, const std::vector<double>& masses, double duration,
                           State& state) {
  auto back = taken_back(start, state.displacement, masses);
  if (!back) return false;
  if (state.taken_back) slow_down(start, state.displacement, *back, duration, state.velocity);
  state.displacement = std::move(*back);
  return true;
}

// Of a vertex that a guard pressed in the step before: the nearest face, on whichever side the vertex is.
void PairSearch::keep_guard_of_vertex(std::uint32_t v) {
  double nearest = skin_ + kMargin * edge_;
  const AlignedBox3d box = around(AlignedBox3d(start_[v]), nearest);
  Passage passage;
  Vertices vertices{};
  for (std::uint32_t body = 0; body < trees_.size(); ++body)
    if (may_touch(body_of_[v], body))
      trees_[body].tree.for_overlaps(box, [&](std::uint32_t k) {
        const Triangle& t = triangles_[trees_[body].triangles[k]];
        if (t[0] == v || t[1] == v || t[2] == v || all_held({v, t[0], t[1], t[2]})) return;
        const Vector3d &a = start_[t[0]], &b = start_[t[1]], &c = start_[t[2]];
        const Vector3d w = nearest_weights(start_[v], a, b, c), between = start_[v] - w[0] * a - w[1] * b - w[2] * c;
        if (w.minCoeff() <= 0 || between.norm() >= nearest) return;
        nearest = between.norm();
        const Vector3d normal = (b - a).cross(c - a).stableNormalized();
        passage = {0, {1, -w[0], -w[1], -w[2]}, normal.dot(between) < 0 ? Vector3d(-normal) : normal};
        vertices = {v, t[0], t[1], t[2]};
      });
  if (vertices[0] != vertices[1]) add_guard(passage, vertices, PairRow::kOfVertex, areas_[v], {guard_of_vertex(v)});
}

// The same of an edge, unless it cuts a face: its side is then not known.
void PairSearch::keep_guard_of_edge(std::uint32_t e) {
  const TissueEdge& edge = edges_[e];
  double nearest = skin_ + kMargin * edge_;
  const AlignedBox3d box = around(AlignedBox3d(start_[edge.from]).extend(start_[edge.to]), nearest);
  Passage passage;
  Vertices vertices{};
  double area = 0;
  bool cuts = false;
  const auto look_at = [&](const TissueEdge& other) {
    const Vertices of{edge.from, edge.to, other.from, other.to};
    if (of[0] == of[2] || of[0] == of[3] || of[1] == of[2] || of[1] == of[3] || all_held(of)) return;
    const Vector3d a = start_[of[1]] - start_[of[0]], b = start_[of[3]] - start_[of[2]];
    const std::optional<Crossing> crossing = crossing_of(start_[of[0]], a, start_[of[2]], b);
    if (!crossing || std::min({crossing->s, 1 - crossing->s, crossing->t, 1 - crossing->t}) < 0) return;
    const Vector3d between = start_[of[0]] + crossing->s * a - start_[of[2]] - crossing->t * b;
    if (between.norm() >= nearest) return;
    nearest = between.norm();
    const Vector3d normal = a.cross(b).normalized();
    passage = {0,
               {1 - crossing->s, crossing->s, crossing->t - 1, -crossing->t},
               normal.dot(between) < 0 ? Vector3d(-normal) : normal};
    vertices = of;
    area = (edge.area + other.area) / 6;
  };
  for (std::uint32_t body = 0; body < trees_.size(); ++body) {
    if (!may_touch(body_of_[edge.from], body)) continue;
    for_cuts(e, body, start_, [&](std::uint32_t) { cuts = true; });
    trees_[body].tree.for_overlaps(box, [&](std::uint32_t k) {
      const std::uint32_t triangle = trees_[body].triangles[k];
      for (const std::uint32_t other : sides_[triangle])
        if (edges_[other].sides[0] == triangle) look_at(edges_[other]);
    });
  }
  if (vertices[0] != vertices[1] && !cuts) add_guard(passage, vertices, PairRow::kOfEdges, area, {guard_of_edge(e)});
}

void PairSearch::keep_guards() {
  guards_.clear();
  rows_.clear();
  for (const std::uint32_t v : vertices_)
    if (pressed_[guard_of_vertex(v)]) keep_guard_of_vertex(v);
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    if (pressed_[guard_of_edge(e)]) keep_guard_of_edge(e);
}

// In place of the pairs of the same features.
void PairSearch::add_guards() {
  if (guards_.empty()) return;
  std::erase_if(rows_, [&](const PairRow& row) {
    return std::any_of(guards_.begin(), guards_.end(), [&](const PairRow& g) { return same_features(row, g); });
  });
  rows_.insert(rows_.end(), guards_.begin(), guards_.end());
}

}  // namespace fascia
