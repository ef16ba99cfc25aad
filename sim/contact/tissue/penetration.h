// What must not be: triangles of the tissue's surface that cut each other, and bodies that begin in each other; and
// when a vertex goes through a triangle, or an edge through an edge, while all of them move on straight: the root of a
// cubic at which the four vertices lie in a plane (Provot 1997).
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// Whether the segment from p to q goes through the triangle a, b, c, by the signs of volumes in double precision.
bool goes_through(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The number of pairs of surface triangles without a common vertex of which an edge of one goes through the other, at
/// displacements [vertex_count] [m].
std::size_t penetrating_triangles(const Model& model, const std::vector<Eigen::Vector3d>& displacement);

/// A body in another one at rest, deeper than a thousandth of its size.
struct Overlap {
  std::uint32_t body, other;           // in Model::bodies
  std::size_t vertices = 0, tets = 0;  // of `body` that lie in `other`; of tets their middles
  double deepest = 0;                  // [m] of them below the surface of `other`
};
/// Of every two bodies, both ways, in the order of the bodies.
std::vector<Overlap> overlaps_at_rest(const Model& model);

struct Passage {
  double share = 0;                 // of the motion [0, 1], the first one
  std::array<double, 4> weights{};  // of the four vertices: they sum to 0, those above 0 are of the first side
  Eigen::Vector3d normal{0, 0, 0};  // a unit vector toward the side that the vertex, or the first edge, comes from
};

/// [m] between two segments, and between a segment that does not go through a triangle and that.
double distance_between(const std::array<Eigen::Vector3d, 2>& a, const std::array<Eigen::Vector3d, 2>& b);
double distance_to_triangle(const std::array<Eigen::Vector3d, 2>& segment, const std::array<Eigen::Vector3d, 3>& t);

/// Vertex 0 and the triangle of vertices 1, 2, 3.
std::optional<Passage> vertex_through_triangle(const std::array<Eigen::Vector3d, 4>& from,
                                               const std::array<Eigen::Vector3d, 4>& to);
/// The edge of vertices 0, 1 and that of 2, 3.
std::optional<Passage> edge_through_edge(const std::array<Eigen::Vector3d, 4>& from,
                                         const std::array<Eigen::Vector3d, 4>& to);

}  // namespace fascia
