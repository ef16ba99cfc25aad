// The loads that hold a body of tets in its shape, as fields instead of forces at vertices, so that functions of a
// higher degree meet them, too: the forces of inner vertices are those of a field, gravity and inertia, which goes on
// to the surface. What surface vertices have beside it is traction. Both are linear between corner vertices.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/mid_edges.h"
#include "sim/model/model.h"

namespace fascia {

struct SpreadLoads {
  std::vector<Eigen::Vector3d> field;     // [vertex_count] at corner vertices, held ones included [m/s^2]
  std::vector<Eigen::Vector3d> traction;  // [vertex_count] at those of the surface [Pa]; zero where held
  std::vector<Triangle> surface;

  Eigen::Vector3d field_at(const Tet& tet, const Eigen::Vector4d& barycentric) const;
};

/// Of the tets in `tets`, whose edges between corners are `edges`. `forces` [vertex_count]: on the functions L_a [N].
SpreadLoads spread_loads(const Model& model, const std::vector<std::uint32_t>& tets,
                         const std::vector<std::array<std::uint32_t, 2>>& edges,
                         const std::vector<Eigen::Vector3d>& forces);

/// Adds `factor` times the forces [N] of a traction that is linear on faces of quadratic tets, to those of vertices.
void add_traction(const Model& model, const std::vector<Triangle>& faces, const std::vector<MidEdge>& edges,
                  const std::vector<Eigen::Vector3d>& traction, double factor, std::vector<Eigen::Vector3d>& forces);

/// At rest [m^2].
double face_area(const Model& model, const Triangle& face);

}  // namespace fascia
