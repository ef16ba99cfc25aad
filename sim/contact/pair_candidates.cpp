// The pairs that a vertex or an edge may be in, by the normals of both sides (pair_search.h).
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "sim/contact/pair_search.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// As shares of the mean edge.
constexpr double kDeepest = 1;  // behind a face a vertex is farther from, it is not what the vertex went through
constexpr double kDeepestCrossing = 0.25;

// Of the skin: by how much nearer another pair must be to take the slot of one that pressed.
constexpr double kKept = 0.25;

// Of barycentric coordinates: along a convex edge between two faces a vertex is above neither. And more of those that
// pressed, and as the sine of an angle for edges: a surface that is pressed flat would let go of what presses it flat.
constexpr double kBeside = 0.05;
constexpr double kBesidePressed = 0.2;
constexpr double kTiltPressed = 0.3;
// Of their distance at rest, by which a vertex and a face of one body can be inside each other: farther is the
// thickness of a part that is crushed.
constexpr double kThin = 1.0 / 3;

// Whether `n`, across an edge along `axis`, is between the outward normals of its sides, or outside by an angle of at
// most the sine `slack`. `first` x `second` is along the axis at a convex edge.
bool between_sides(const Vector3d& n, const Vector3d& first, const Vector3d& second, const Vector3d& axis,
                   double slack) {
  return first.cross(n).dot(axis) >= -slack && n.cross(second).dot(axis) >= -slack && n.dot(first + second) > 0;
}

}  // namespace

std::optional<PairSearch::Crossing> PairSearch::crossing_of(const Vector3d& a, const Vector3d& along_a,
                                                            const Vector3d& b, const Vector3d& along_b) {
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  const double det = aa * bb - ab * ab;
  if (det <= 1e-6 * aa * bb) return std::nullopt;
  const Vector3d between = b - a;
  const double p = between.dot(along_a), q = between.dot(along_b);
  return Crossing{(bb * p - ab * q) / det, (ab * p - aa * q) / det};
}

// Such that the normals of the sides turn about it in the order of the sides, if the edge is convex.
Vector3d PairSearch::along(const TissueEdge& edge) const {
  const Triangle& t = triangles_[edge.sides[0]];
  const bool ascends = (t[0] == edge.from && t[1] == edge.to) || (t[1] == edge.from && t[2] == edge.to) ||
                       (t[2] == edge.from && t[0] == edge.to);
  const Vector3d axis = (start_[edge.to] - start_[edge.from]).stableNormalized();
  return ascends ? axis : Vector3d(-axis);
}

void PairSearch::offer(const Candidate& candidate) {
  std::uint32_t& holder = holder_[candidate.row.slot];
  if (holder == kNone) {
    holder = static_cast<std::uint32_t>(rows_.size());
    rows_.push_back(candidate.row);
    cost_[candidate.row.slot] = candidate.distance;
  } else if (candidate.distance < cost_[candidate.row.slot]) {
    rows_[holder] = candidate.row;
    cost_[candidate.row.slot] = candidate.distance;
  }
}

// Of crossing edges the deepest come first, since any of them may be what holds the surfaces apart. A pair is
// remembered by either of its edges. A slot that remembers one of the crossings is left to it; of the others, one whose
// crossing is gone comes first, since that has slid to the new one.
void PairSearch::choose_crossings() {
  std::sort(crossings_.begin(), crossings_.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.distance, a.first, a.second) < std::tuple(b.distance, b.first, b.second);
  });
  claimed_.assign(slot_count_, 0);
  for (const Candidate& crossing : crossings_)
    if (crossing.kept != kNone) claimed_[crossing.kept] = 1;
  for (Candidate& crossing : crossings_) {
    std::uint32_t chosen = kNone;
    int rank = 3;
    const auto consider = [&](std::uint32_t slot) {
      const int its = slot == crossing.kept ? -1 : claimed_[slot] ? 2 : pressed_[slot] ? 0 : 1;
      if (holder_[slot] != kNone || its >= rank) return;
      chosen = slot;
      rank = its;
    };
    for (const std::uint32_t edge : {crossing.first, crossing.second})
      for (std::uint32_t k = 0; k < kEdgeSlots; ++k) consider(first_slot_of_edge(edge) + k);
    if (chosen == kNone) continue;
    holder_[chosen] = static_cast<std::uint32_t>(rows_.size());
    crossing.row.slot = chosen;
    const std::uint32_t own = (chosen - first_slot_of_edge(0)) / kEdgeSlots;
    crossing.row.met = 1 + (own == crossing.first ? crossing.second : crossing.first);
    rows_.push_back(crossing.row);
  }
}

// Beside a face, at a convex edge, the nearest point is on the edge, and the normal turns from one face to the other as
// the vertex goes around: by the face's own it would stop a body whose edge slides over it. The moment is that at which
// their distance, which is convex in time, first is half the skin, or where it is least: of a vertex that an edge
// passes over in the step, the normal is then across the way.
std::optional<PairSearch::Beside> PairSearch::approach_beside(std::uint32_t v, const Triangle& t) const {
  constexpr int kHalves = 12;
  const double grazed = kGrazed * skin_between(body_of_[v], body_of_[t[0]]);
  const auto at = [&](double share) {
    const auto place = [&](std::uint32_t i) { return Vector3d(start_[i] + share * (end_[i] - start_[i])); };
    const std::array<Vector3d, 3> corners = {place(t[0]), place(t[1]), place(t[2])};
    Beside beside;
    beside.weights = nearest_weights(place(v), corners[0], corners[1], corners[2]);
    beside.normal = place(v);
    for (int k = 0; k < 3; ++k) beside.normal -= beside.weights[k] * corners[static_cast<std::size_t>(k)];
    beside.distance = beside.normal.norm();
    return beside;
  };
  Beside found = at(0);
  if (found.distance > grazed) {
    double low = 0, high = 1;
    for (int half = 0; half < kHalves; ++half) {  // towards where the distance is least, or first below the skin
      const double middle = 0.5 * (low + high), little = 1e-3 * (high - low);
      const Beside here = at(middle);
      (here.distance <= grazed || at(middle + little).distance >= here.distance ? high : low) = middle;
    }
    found = at(high);
  }
  if (!(found.distance > 0)) return std::nullopt;
  found.normal /= found.distance;
  return found;
}

// The edge or corner, if the normal is between those of the faces there. Else the vertex is above another face: where
// that one is folded away it is another pair's, and along the face's own normal it would be stopped from the side.
PairSearch::Facing PairSearch::facing_of(const Beside& beside, std::uint32_t triangle) const {
  constexpr double kFolded = 0.866, kAside = 0.5;  // cosines
  const Triangle& t = triangles_[triangle];
  const Vector3d &n = beside.normal, &own = normals_[triangle];
  const auto is_aside = [&](const Vector3d& other) {
    return beside.distance > kGrazed * skin_ && own.dot(other) < kFolded && n.dot(own) < kAside &&
           n.dot(other) > std::max(0.0, n.dot(own));
  };
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (beside.weights[k] == 1) {
      const Vector3d around = vertex_normals_[t[at]].stableNormalized();
      if (n.dot(around) >= own.dot(around)) return Facing::edge;
      return is_aside(around) ? Facing::other_face : Facing::face;
    }
    if (beside.weights[k] > 0) continue;
    for (const std::uint32_t e : sides_[triangle]) {
      const TissueEdge& edge = edges_[e];
      if (edge.from == t[at] || edge.to == t[at] || edge.sides[1] == TissueEdge::kNoSide) continue;
      const Vector3d& other = normals_[edge.sides[edge.sides[0] == triangle ? 1 : 0]];
      const Vector3d axis = own.cross(other);
      if (own.cross(n).dot(axis) > 0 && n.cross(other).dot(axis) > 0) return Facing::edge;
      return is_aside(other) ? Facing::other_face : Facing::face;
    }
  }
  return Facing::face;
}

void PairSearch::try_vertex(std::uint32_t v, std::size_t index, std::uint32_t triangle) {
  const Triangle& t = triangles_[triangle];
  if (vertex_normals_[v].dot(normals_[triangle]) >= -facing_[v]) return;
  if (t[0] == v || t[1] == v || t[2] == v) return;
  if (held_[v] && held_[t[0]] && held_[t[1]] && held_[t[2]]) return;
  const auto gap_at = [&](double share, Vector3d& normal, Vector3d& local, std::array<Vector3d, 3>& corners) {
    const auto at = [&](std::uint32_t i) { return Vector3d(start_[i] + share * (end_[i] - start_[i])); };
    for (std::size_t k = 0; k < 3; ++k) corners[k] = at(t[k]);
    normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    local = at(v) - corners[0];
    return normal.dot(local) / normal.norm();
  };
  Vector3d normal, local;
  std::array<Vector3d, 3> corners;
  const double from = gap_at(0, normal, local, corners);
  if (!(from >= -kDeepest * edge_)) return;  // or a triangle without area
  const double to = gap_at(1, normal, local, corners);
  if (!std::isfinite(to)) return;
  const double way = way_of(v) + std::max({way_of(t[0]), way_of(t[1]), way_of(t[2])});
  if (std::min(from, to) > skin_ + kMargin * (edge_ + way)) return;
  see_near({v, t[0], t[1], t[2]});
  const double share = from <= skin_ || to >= from ? 0 : std::min(1.0, (from - skin_) / (from - to));
  const double then = gap_at(share, normal, local, corners);
  if (!std::isfinite(then)) return;
  const double twice_area2 = normal.squaredNorm();
  const Vector3d b = corners[1] - corners[0], c = corners[2] - corners[0];
  const double beta = local.cross(c).dot(normal) / twice_area2, gamma = b.cross(local).dot(normal) / twice_area2;
  Vector3d weights(1 - beta - gamma, beta, gamma);
  const double least = weights.minCoeff();
  const std::uint32_t slot = static_cast<std::uint32_t>(index) * body_slots_ + body_of_[t[0]] % body_slots_;
  if (least < -(pressed_[slot] ? kBesidePressed : kBeside)) return;
  normal.normalize();
  double distance = std::abs(then) + std::max(0.0, -least) * edge_;
  if (least < 0)
    if (const auto beside = approach_beside(v, t)) {
      const Facing facing = facing_of(*beside, triangle);
      if (facing == Facing::other_face) return;
      if (facing == Facing::edge && then > 0) {
        weights = beside->weights;
        normal = beside->normal;
        distance = beside->distance;
      }
    }
  const std::uint32_t body = body_of_[v], other = body_of_[t[0]];
  if (body == other) {
    const Vector3d w = nearest_weights(rest_[v], rest_[t[0]], rest_[t[1]], rest_[t[2]]);
    const double at_rest = (rest_[v] - w[0] * rest_[t[0]] - w[1] * rest_[t[1]] - w[2] * rest_[t[2]]).norm();
    if (at_rest < 2 * skin_ || -from > kThin * at_rest) return;
  }
  Candidate candidate;
  PairRow& row = candidate.row;
  row.vertices = {v, t[0], t[1], t[2]};
  row.weights = {1, -weights[0], -weights[1], -weights[2]};
  row.normal = normal;
  row.stiffness = penalty_ * areas_[v] / softness_of(row);
  row.slot = slot;
  row.bodies = {body, other};
  row.met = triangle + 1;
  candidate.distance = distance - (remembers(slot, triangle) ? kKept * skin_ : 0);
  offer(candidate);
}

void PairSearch::try_edges(std::uint32_t first, std::uint32_t second) {
  const TissueEdge &a = edges_[first], &b = edges_[second];
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return;
  if (held_[a.from] && held_[a.to] && held_[b.from] && held_[b.to]) return;
  const Vector3d &a0 = normals_[a.sides[0]], &a1 = normals_[a.sides[1]], &b0 = normals_[b.sides[0]],
                 &b1 = normals_[b.sides[1]];
  if (normal_sum(a).dot(normal_sum(b)) >= 0) return;
  // n points from the second to the first.
  Vector3d normal;
  Crossing crossing;
  const auto gap_at = [&](double share) -> std::optional<double> {
    const auto at = [&](std::uint32_t i) { return Vector3d(start_[i] + share * (end_[i] - start_[i])); };
    const Vector3d p = at(a.from), q = at(b.from), along_a = at(a.to) - p, along_b = at(b.to) - q;
    const std::optional<Crossing> found = crossing_of(p, along_a, q, along_b);
    if (!found) return std::nullopt;
    crossing = *found;
    normal = along_a.cross(along_b).normalized();
    if (normal.dot(b0 + b1) < 0) normal = -normal;
    return normal.dot(p + crossing.s * along_a - q - crossing.t * along_b);
  };
  const std::optional<double> from = gap_at(0);
  if (!from || *from < -kDeepestCrossing * edge_) return;
  const std::optional<double> to = gap_at(1);
  if (!to) return;
  const double way = std::max(way_of(a.from), way_of(a.to)) + std::max(way_of(b.from), way_of(b.to));
  if (std::min(*from, *to) > skin_ + kMargin * (edge_ + way)) return;
  see_near({a.from, a.to, b.from, b.to});
  const double share = *from <= skin_ || *to >= *from ? 0 : std::min(1.0, (*from - skin_) / (*from - *to));
  const std::optional<double> then = gap_at(share);
  const bool pressed = edge_pressed(first) || edge_pressed(second);
  const double beside = pressed ? kBesidePressed : 0;
  if (!then || std::min({crossing.s, 1 - crossing.s, crossing.t, 1 - crossing.t}) < -beside) return;
  const double slack = pressed ? kTiltPressed : 0;
  if (!between_sides(normal, b0, b1, along(b), slack) || !between_sides(-normal, a0, a1, along(a), slack)) return;
  const std::uint32_t body = body_of_[a.from], other = body_of_[b.from];
  if (body == other) {
    const auto at_rest = [&](const TissueEdge& e, double share_of_edge) {
      return Vector3d(rest_[e.from] + share_of_edge * (rest_[e.to] - rest_[e.from]));
    };
    const double distance = (at_rest(a, crossing.s) - at_rest(b, crossing.t)).norm();
    if (distance < 2 * skin_ || -*from > kThin * distance) return;
  }
  Candidate candidate;
  PairRow& row = candidate.row;
  row.vertices = {a.from, a.to, b.from, b.to};
  row.weights = {1 - crossing.s, crossing.s, crossing.t - 1, -crossing.t};
  row.sides = PairRow::kOfEdges;
  row.normal = normal;
  row.stiffness = penalty_ * (a.area + b.area) / 6 / softness_of(row);
  row.bodies = {body, other};
  candidate.distance = *then;
  candidate.first = first;
  candidate.second = second;
  for (std::uint32_t k = 0; k < kEdgeSlots; ++k) {
    if (remembers(first_slot_of_edge(first) + k, second)) candidate.kept = first_slot_of_edge(first) + k;
    if (remembers(first_slot_of_edge(second) + k, first)) candidate.kept = first_slot_of_edge(second) + k;
  }
  if (candidate.kept != kNone) candidate.distance -= kKept * skin_;
  crossings_.push_back(candidate);
}

void PairSearch::look_at_vertex(std::size_t index, std::uint32_t body) {
  const std::uint32_t v = vertices_[index];
  AlignedBox3d box(start_[v]);
  box.extend(end_[v]);
  const double reach = std::max(kDeepest * edge_, skin_ + kMargin * (edge_ + way_of(v)));
  box.extend(Vector3d(box.min().array() - reach)).extend(Vector3d(box.max().array() + reach));
  trees_[body].tree.for_opposed(box, vertex_normals_[v],
                                [&](std::uint32_t k) { try_vertex(v, index, trees_[body].triangles[k]); });
}

void PairSearch::look_at_edge(std::uint32_t e, std::uint32_t body) {
  const TissueEdge& edge = edges_[e];
  AlignedBox3d box(start_[edge.from]);
  box.extend(end_[edge.from]).extend(start_[edge.to]).extend(end_[edge.to]);
  const double reach = skin_ + kMargin * (edge_ + std::max(way_of(edge.from), way_of(edge.to)));
  box.extend(Vector3d(box.min().array() - reach)).extend(Vector3d(box.max().array() + reach));
  trees_[body].tree.for_opposed(box, normal_sum(edge), [&](std::uint32_t k) {
    const std::uint32_t triangle = trees_[body].triangles[k];
    for (const std::uint32_t other : sides_[triangle])
      // An edge is met from either of its sides, and two of one body from either edge.
      if (convex_[other] && edges_[other].sides[0] == triangle && (body != body_of_[edge.from] || e < other))
        try_edges(e, other);
  });
}

}  // namespace fascia
