#include "sim/contact/passing/clear_way.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kShortestStep = 0.125;  // of the finest part: along a way near a shape or in it
constexpr double kShallow = 0.01;        // of the finest part: what presses is in a tool by less
constexpr double kDeep = 0.25;           // of the finest part: beyond it a start has no side
constexpr double kTouching = 1e-3;       // of the skin: what a scene sets on each other without a gap is on no side yet
constexpr double kSameSide = 0.5;        // least cosine between the normals where a point enters and where it ends

Vector3d place_of(const Model& model, const VectorXd& u, std::size_t v) {
  return model.rest_positions[v] + u.segment<3>(3 * static_cast<Eigen::Index>(v));
}

}  // namespace

bool goes_through(const ToolShape& shape, const Vector3d& from, const Vector3d& to, double half_thickness) {
  const double finest = finest_radius(shape), length = (to - from).norm();
  if (length == 0 || !std::isfinite(length) || !std::isfinite(finest)) return false;  // a plane has one side
  std::optional<Vector3d> entry;
  for (double gone = 0; gone < length;) {
    const ShapeDistance here = distance_to(shape, from + gone / length * (to - from));
    const double distance = here.distance - half_thickness;
    if (gone == 0 && distance < -kDeep * finest) return false;
    if (distance < -kShallow * finest) {
      entry = here.normal.normalized();
      break;
    }
    gone += std::max(distance, kShortestStep * finest);
  }
  return entry && entry->dot(distance_to(shape, to).normal.normalized()) < kSameSide;
}

ClearWay::ClearWay(const Model& model, const ContactSurface& contact, double skin)
    : model_(model), contact_(contact), skin_(skin) {
  if (!model.contact.bodies || model.bodies.size() < 2) return;
  triangles_ = tissue_boundary(model);
  edges_ = tissue_edges(model, triangles_);
  body_of_ = bodies_of_vertices(model);
  bodies_.resize(model.bodies.size());
  std::vector<char> seen(model.rest_positions.size(), 0);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    Body& body = bodies_[body_of_[triangles_[t][0]]];
    body.triangles.push_back(t);
    for (const std::uint32_t v : triangles_[t])
      if (!std::exchange(seen[v], 1)) body.vertices.push_back(v);
  }
  sides_.resize(triangles_.size());
  std::vector<std::uint8_t> named(triangles_.size(), 0);
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    bodies_[body_of_[edges_[e].from]].edges.push_back(e);
    for (const std::uint32_t side : edges_[e].sides)
      if (side != TissueEdge::kNoSide && named[side] < 3) sides_[side][named[side]++] = e;
  }
  for (Body& body : bodies_) {
    std::vector<Vector3d> middles;
    for (const std::uint32_t t : body.triangles) {
      const auto& x = model.rest_positions;
      middles.push_back((x[triangles_[t][0]] + x[triangles_[t][1]] + x[triangles_[t][2]]) / 3);
    }
    body.tree = BoxTree(middles);
  }
}

bool ClearWay::operator()(const VectorXd& from, const VectorXd& to, const ToolMotion& motion) {
  return std::all_of(contact_.pieces.begin(), contact_.pieces.end(),
                     [&](const ContactPiece& piece) { return clear_of(piece, from, to, motion); }) &&
         clear_of_tissue(from, to);
}

bool ClearWay::of_moving_tools(const VectorXd& from, const VectorXd& to, const ToolMotion& motion) const {
  return std::all_of(contact_.pieces.begin(), contact_.pieces.end(), [&](const ContactPiece& piece) {
    return motion.from[piece.tool] == motion.to[piece.tool] || clear_of(piece, from, to, motion);
  });
}

bool ClearWay::clear_of(const ContactPiece& piece, const VectorXd& from, const VectorXd& to,
                        const ToolMotion& motion) const {
  const Tool& tool = model_.tools[piece.tool];
  const RigidPose begin = tool.pose_of_piece(piece.piece, motion.from[piece.tool]);
  const RigidPose end = tool.pose_of_piece(piece.piece, motion.to[piece.tool]);
  for (std::uint32_t p = 0; p < piece.points; ++p) {
    const ContactPoint& point = contact_.points[p];
    if (goes_through(tool.shape, begin.to_local(point.place(model_.rest_positions, from)),
                     end.to_local(point.place(model_.rest_positions, to)), 0.5 * model_.contact.thickness))
      return false;
  }
  return true;
}

Vector3d ClearWay::normal_at(double share, std::uint32_t triangle) const {
  const auto now = [&](std::uint32_t v) -> Vector3d { return from_[v] + share * (to_[v] - from_[v]); };
  const Triangle& t = triangles_[triangle];
  const Vector3d a = now(t[0]);
  return (now(t[1]) - a).cross(now(t[2]) - a);
}

bool ClearWay::touched(const Passage& passage, const std::array<std::uint32_t, 4>& vertices) const {
  Vector3d between(0, 0, 0);
  for (std::size_t k = 0; k < 4; ++k) between += passage.weights[k] * from_[vertices[k]];
  return std::abs(passage.normal.dot(between)) < kTouching * skin_;
}

bool ClearWay::enters(std::uint32_t v, const Triangle& t) const {
  const std::array<std::uint32_t, 4> of{v, t[0], t[1], t[2]};
  const auto passage = vertex_through_triangle(at(from_, of), at(to_, of));
  if (!passage || touched(*passage, of)) return false;
  const auto triangle = static_cast<std::uint32_t>(&t - triangles_.data());
  return passage->normal.dot(normal_at(passage->share, triangle)) > 0;
}

bool ClearWay::enters(const TissueEdge& first, const TissueEdge& second) const {
  const std::array<std::uint32_t, 4> of{first.from, first.to, second.from, second.to};
  const auto passage = edge_through_edge(at(from_, of), at(to_, of));
  if (!passage || touched(*passage, of)) return false;
  const auto outward = [&](const TissueEdge& edge) {
    Vector3d sum(0, 0, 0);
    for (const std::uint32_t side : edge.sides)
      if (side != TissueEdge::kNoSide) sum += normal_at(passage->share, side).stableNormalized();
    return sum;
  };
  return passage->normal.dot(outward(second)) > 0 && passage->normal.dot(outward(first)) < 0;
}

// And fits the trees around the ways between.
void ClearWay::place(const VectorXd& from, const VectorXd& to) {
  const std::size_t count = model_.rest_positions.size();
  from_.resize(count);
  to_.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    from_[v] = place_of(model_, from, v);
    to_[v] = place_of(model_, to, v);
  }
  for (Body& body : bodies_) {
    std::vector<AlignedBox3d> boxes;
    for (const std::uint32_t t : body.triangles) {
      AlignedBox3d& box = boxes.emplace_back();
      for (const std::uint32_t v : triangles_[t]) box.extend(way_of(v));
    }
    body.tree.fit(boxes);
  }
}

bool ClearWay::cuts(const VectorXd& from, const VectorXd& to) {
  if (bodies_.empty()) return false;
  const std::vector<std::uint32_t> none;
  const auto bodies_cut = [&](const VectorXd& u) {
    place(u, u);
    std::set<std::pair<std::size_t, std::size_t>> cut;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (const std::uint32_t e : a == b ? none : bodies_[a].edges) {
          const Vector3d &p = to_[edges_[e].from], &q = to_[edges_[e].to];
          bodies_[b].tree.for_overlaps(AlignedBox3d(p).extend(q), [&](std::uint32_t k) {
            const Triangle& t = triangles_[bodies_[b].triangles[k]];
            if (goes_through(p, q, to_[t[0]], to_[t[1]], to_[t[2]])) cut.insert(std::minmax(a, b));
          });
        }
    return cut;
  };
  const auto before = bodies_cut(from), after = bodies_cut(to);
  return !std::includes(before.begin(), before.end(), after.begin(), after.end());
}

bool ClearWay::clear_of_tissue(const VectorXd& from, const VectorXd& to) {
  if (bodies_.empty()) return true;
  place(from, to);
  bool clear = true;
  for (std::size_t a = 0; a < bodies_.size(); ++a)
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (a == b) continue;
      const Body &own = bodies_[a], &other = bodies_[b];
      for (std::size_t i = 0; clear && i < own.vertices.size(); ++i)
        other.tree.for_overlaps(way_of(own.vertices[i]), [&](std::uint32_t k) {
          clear = clear && !enters(own.vertices[i], triangles_[other.triangles[k]]);
        });
      for (std::size_t i = 0; clear && a < b && i < own.edges.size(); ++i) {
        const TissueEdge& edge = edges_[own.edges[i]];
        other.tree.for_overlaps(way_of(edge.from).extend(way_of(edge.to)), [&](std::uint32_t k) {
          const std::uint32_t triangle = other.triangles[k];
          for (const std::uint32_t e : sides_[triangle])
            clear = clear && !(edges_[e].sides[0] == triangle && enters(edge, edges_[e]));
        });
      }
      if (!clear) return false;
    }
  return true;
}

}  // namespace fascia
