// The rigid motions of the pieces of a mesh that nothing holds.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// The pieces of which no vertex is held, each by its corner vertices in ascending order.
std::vector<std::vector<std::uint32_t>> free_pieces(const std::vector<Tet>& tets, const std::vector<char>& held);

/// What is left of the way from `rest` to `now` [m] ([vertex of the piece]) beside the rigid motion that comes nearest
/// to it (Kabsch 1976).
std::vector<Eigen::Vector3d> deformation(const std::vector<Eigen::Vector3d>& rest,
                                         const std::vector<Eigen::Vector3d>& now);

/// Small rigid motions of several sets of vertices, to take them out of the motion of a mesh.
class RigidMotions {
 public:
  /// Of vertices at these places; none of them in two sets.
  void add(const std::vector<std::uint32_t>& vertices, const std::vector<Eigen::Vector3d>& places);

  /// Leaves of motions or forces [vertex of the mesh] what does no work on the rigid motions.
  void remove_from(std::vector<Eigen::Vector3d>& vectors) const;

 private:
  struct Set {
    std::vector<std::uint32_t> vertices;
    Eigen::Matrix<double, Eigen::Dynamic, 6> motions;  // [3 x vertex] an orthonormal basis
  };
  std::vector<Set> sets_;
};

}  // namespace fascia
