#include "sim/surface/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace fascia {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr std::uint32_t kLeaf = 4;      // triangles
constexpr double kDipoleRadii = 2.5;    // radii from which a group of triangles counts as one dipole
constexpr double kSameCrossing = 1e-9;  // shares of a segment
constexpr std::size_t kDeepest = 64;    // halving 2^32 triangles

bool has(const Triangle& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

bool share_vertex(const Triangle& a, const Triangle& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t v) { return v != kNoVertex && has(b, v); });
}

/// Solid angle of a triangle as seen from the origin [sr] (Van Oosterom, Strackee 1983).
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double volume = a.dot(b.cross(c));
  return 2 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

bool touches(const AlignedBox3d& box, const Vector3d& a, const Vector3d& inverse) {
  double enter = 0, leave = 1;
  for (int k = 0; k < 3; ++k) {
    double first = (box.min()[k] - a[k]) * inverse[k], second = (box.max()[k] - a[k]) * inverse[k];
    if (first > second) std::swap(first, second);
    // A NaN (a on a side of the box, along that side) excludes nothing.
    if (first > enter) enter = first;
    if (second < leave) leave = second;
  }
  return enter <= leave * (1 + 1e-12) + 1e-12;
}

}  // namespace

Vector3d nearest_weights(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double share = d1 == d3 ? 0 : d1 / (d1 - d3);
    return {1 - share, share, 0};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double share = d2 == d6 ? 0 : d2 / (d2 - d6);
    return {1 - share, 0, share};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double length = (d4 - d3) + (d5 - d6), share = length == 0 ? 0 : (d4 - d3) / length;
    return {0, 1 - share, share};
  }
  const double sum = va + vb + vc;
  return Vector3d(va, vb, vc) / sum;
}

TriangleTree::TriangleTree(std::vector<Vector3d> positions, std::vector<Triangle> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  if (triangles_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vector3d> centers;
  centers.reserve(triangles_.size());
  for (const auto& [a, b, c] : triangles_) centers.push_back((positions_[a] + positions_[b] + positions_[c]) / 3);
  nodes_.reserve(triangles_.size());
  build(0, static_cast<std::uint32_t>(triangles_.size()), centers);
}

std::array<Vector3d, 3> TriangleTree::corners(std::uint32_t place) const {
  const Triangle& t = triangles_[order_[place]];
  return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
}

void TriangleTree::build(std::uint32_t begin, std::uint32_t end, const std::vector<Vector3d>& centers) {
  const std::size_t at = nodes_.size();
  Node node{AlignedBox3d(), begin, end, 0, Vector3d::Zero(), Vector3d::Zero(), 0};
  AlignedBox3d spread;
  double total = 0;
  for (std::uint32_t place = begin; place < end; ++place) {
    const auto [a, b, c] = corners(place);
    const Vector3d area = (b - a).cross(c - a) / 2;
    for (const Vector3d& p : {a, b, c}) node.box.extend(p);
    spread.extend(centers[order_[place]]);
    node.area += area;
    node.center += area.norm() * centers[order_[place]];
    total += area.norm();
  }
  node.center = total > 0 ? Vector3d(node.center / total) : node.box.center();
  for (std::uint32_t place = begin; place < end; ++place)
    for (const Vector3d& p : corners(place)) node.radius = std::max(node.radius, (p - node.center).norm());
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return;
  int axis = 0;
  spread.sizes().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return centers[a][axis] != centers[b][axis] ? centers[a][axis] < centers[b][axis] : a < b;
                   });
  build(begin, middle, centers);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end, centers);
}

double TriangleTree::winding(const Vector3d& p) const {
  if (nodes_.empty()) return 0;
  double angle = 0;
  std::array<std::uint32_t, kDeepest> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const std::uint32_t at = stack[--height];
    const Node& node = nodes_[at];
    const Vector3d to = node.center - p;
    const double distance2 = to.squaredNorm();
    if (distance2 > kDipoleRadii * kDipoleRadii * node.radius * node.radius) {
      angle += node.area.dot(to) / (distance2 * std::sqrt(distance2));
    } else if (node.right == 0) {
      for (std::uint32_t place = node.begin; place < node.end; ++place) {
        const auto [a, b, c] = corners(place);
        angle += solid_angle(a - p, b - p, c - p);
      }
    } else {
      stack[height++] = node.right;
      stack[height++] = at + 1;
    }
  }
  return angle / (4 * std::numbers::pi);
}

std::vector<double> TriangleTree::crossings(const Vector3d& a, const Vector3d& b) const {
  std::vector<double> shares;
  if (nodes_.empty()) return shares;
  const Vector3d along = b - a, inverse = along.cwiseInverse();
  std::array<std::uint32_t, kDeepest> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const std::uint32_t at = stack[--height];
    const Node& node = nodes_[at];
    if (!touches(node.box, a, inverse)) continue;
    if (node.right != 0) {
      stack[height++] = node.right;
      stack[height++] = at + 1;
      continue;
    }
    for (std::uint32_t place = node.begin; place < node.end; ++place) {  // Moeller, Trumbore 1997
      const auto [p, q, r] = corners(place);
      const Vector3d pq = q - p, pr = r - p, cross = along.cross(pr);
      const double det = pq.dot(cross);
      if (det == 0) continue;
      const Vector3d from = a - p, other = from.cross(pq);
      const double u = from.dot(cross) / det, v = along.dot(other) / det, t = pr.dot(other) / det;
      constexpr double kSlack = 1e-9;  // rather two triangles at a shared edge than none
      if (u >= -kSlack && v >= -kSlack && u + v <= 1 + kSlack && t >= 0 && t <= 1) shares.push_back(t);
    }
  }
  std::sort(shares.begin(), shares.end());
  const auto same = [](double first, double second) { return second - first < kSameCrossing; };
  shares.erase(std::unique(shares.begin(), shares.end(), same), shares.end());
  return shares;
}

TriangleTree::Nearest TriangleTree::nearest(const Vector3d& p) const {
  Nearest best{0, p, std::numeric_limits<double>::infinity()};
  double best2 = best.distance;
  struct Entry {
    std::uint32_t node;
    double distance2;
  };
  std::array<Entry, kDeepest> stack;
  std::size_t height = 0;
  stack[height++] = {0, 0};
  while (height > 0) {
    const Entry entry = stack[--height];
    if (entry.distance2 >= best2) continue;
    const Node& node = nodes_[entry.node];
    if (node.right != 0) {
      Entry left{entry.node + 1, nodes_[entry.node + 1].box.squaredExteriorDistance(p)};
      Entry right{node.right, nodes_[node.right].box.squaredExteriorDistance(p)};
      if (left.distance2 < right.distance2) std::swap(left, right);  // the nearer one is visited first
      stack[height++] = left;
      stack[height++] = right;
      continue;
    }
    for (std::uint32_t place = node.begin; place < node.end; ++place) {
      const auto [a, b, c] = corners(place);
      const Vector3d w = nearest_weights(p, a, b, c);
      const Vector3d point = w[0] * a + w[1] * b + w[2] * c;
      const double distance2 = (point - p).squaredNorm();
      if (!(distance2 < best2)) continue;
      best2 = distance2;
      best = {order_[place], point, 0};
    }
  }
  best.distance = std::sqrt(best2);
  return best;
}

/// Vertices that all triangles of a leaf share; kNoVertex in the other places.
Triangle TriangleTree::common_vertices(const Node& node) const {
  Triangle common = triangles_[order_[node.begin]];
  for (std::uint32_t place = node.begin + 1; place < node.end; ++place)
    for (std::uint32_t& v : common)
      if (!has(triangles_[order_[place]], v)) v = kNoVertex;
  return common;
}

bool TriangleTree::for_touching_pairs(const std::function<void(std::size_t, std::size_t)>& f,
                                      const std::function<bool(std::size_t)>& go_on) const {
  if (nodes_.empty()) return true;
  // Around a vertex with thousands of triangles all boxes touch, and no pair counts: two nodes with a common vertex are
  // skipped.
  std::vector<Triangle> common(nodes_.size());
  for (std::size_t at = nodes_.size(); at-- > 0;) {  // children follow their parents
    const Node& node = nodes_[at];
    common[at] = node.right == 0 ? common_vertices(node) : common[at + 1];
    if (node.right == 0) continue;
    for (std::uint32_t& v : common[at])
      if (!has(common[node.right], v)) v = kNoVertex;
  }
  std::vector<Eigen::AlignedBox3d> boxes(order_.size());
  for (std::uint32_t place = 0; place < order_.size(); ++place)
    for (const Vector3d& corner : corners(place)) boxes[place].extend(corner);
  std::size_t compared = 0;
  const auto compare = [&](std::uint32_t one, std::uint32_t other) {
    ++compared;
    if (!boxes[one].intersects(boxes[other])) return;
    const std::size_t t = order_[one], u = order_[other];
    if (!share_vertex(triangles_[t], triangles_[u])) f(std::min(t, u), std::max(t, u));
  };
  std::vector<std::array<std::uint32_t, 2>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [one, other] = stack.back();
    stack.pop_back();
    if (!go_on(compared)) return false;
    ++compared;
    const Node &a = nodes_[one], &b = nodes_[other];
    if (share_vertex(common[one], common[other]) || !a.box.intersects(b.box)) continue;
    if (a.right == 0 && b.right == 0) {
      for (std::uint32_t i = a.begin; i < a.end; ++i)
        for (std::uint32_t k = one == other ? i + 1 : b.begin; k < b.end; ++k) compare(i, k);
    } else if (one == other) {
      stack.insert(stack.end(), {{one + 1, one + 1}, {a.right, a.right}, {one + 1, a.right}});
    } else if (b.right == 0 || (a.right != 0 && a.end - a.begin >= b.end - b.begin)) {
      stack.insert(stack.end(), {{one + 1, other}, {a.right, other}});
    } else {
      stack.insert(stack.end(), {{one, other + 1}, {one, b.right}});
    }
  }
  return true;
}

}  // namespace fascia
