// A tree of boxes over the triangles of a surface, for queries: whether a point is inside, where a segment crosses the
// surface, which point is nearest.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

class TriangleTree {
 public:
  /// Copies its arguments; the triangles may be an arbitrary soup.
  TriangleTree(std::vector<Eigen::Vector3d> positions, std::vector<Triangle> triangles);

  /// Generalized winding number of the point (Jacobson, Kavan, Sorkine-Hornung 2013): 1 inside a closed surface wound
  /// outward, 0 outside, and in between near holes. Far groups of triangles count as one dipole (Barill et al. 2018,
  /// first order); error below 0.05.
  double winding(const Eigen::Vector3d& point) const;
  bool is_inside(const Eigen::Vector3d& point) const { return winding(point) > 0.5; }

  /// Intersections of the segment from a to b with triangles: shares of its length, ascending, equal ones (at a shared
  /// edge) once.
  std::vector<double> crossings(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  struct Nearest {
    std::size_t triangle;
    Eigen::Vector3d point;  // of that triangle
    double distance;        // [m]
  };
  /// Precondition: there is a triangle.
  Nearest nearest(const Eigen::Vector3d& point) const;

  /// Calls f(t, other), t < other, for every two triangles whose boxes touch and that share no vertex. Ends early with
  /// false if go_on(box pairs compared so far) returns false.
  bool for_touching_pairs(const std::function<void(std::size_t, std::size_t)>& f,
                          const std::function<bool(std::size_t)>& go_on) const;

  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  Eigen::AlignedBox3d box() const { return nodes_.empty() ? Eigen::AlignedBox3d() : nodes_[0].box; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t begin, end;      // in order_
    std::uint32_t right = 0;       // right child; the left one follows its parent; 0: a leaf
    Eigen::Vector3d center, area;  // of the dipole: center of area, and sum of the area vectors
    double radius;                 // of a ball around the center that contains the triangles
  };
  void build(std::uint32_t begin, std::uint32_t end, const std::vector<Eigen::Vector3d>& centers);
  std::array<Eigen::Vector3d, 3> corners(std::uint32_t place) const;
  Triangle common_vertices(const Node& node) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> order_;  // triangles in the order of the leaves
  std::vector<Node> nodes_;
};

/// The point of the triangle nearest to p, as weights of its corners (Ericson 2005, 5.1.5).
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c);

}  // namespace fascia
