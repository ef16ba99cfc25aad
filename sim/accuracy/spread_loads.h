// The loads that hold a body of tets in its shape, as fields instead of forces at vertices, so that functions of a
// higher degree and finer meshes meet them, too: the forces of inner vertices are those of a field, gravity and
// inertia, which goes on to the surface and is linear between corner vertices. What surface vertices have beside it is
// traction.
//
// Many tractions have the same forces at vertices. Of those on one face, the one taken is the least in the mean square,
//
//   t = sum_i F_i sum_j (M^-1)_ij N_j,    M_ij = int N_i N_j dA,
//
// the dual functions of Scott, Zhang 1990, with the forces F_i of the face on its functions N_i, linear or quadratic: a
// force at one vertex is spread over the faces around it, with a finite energy. For even tractions that is the even
// traction. A vertex shares its force among its faces by how much all of their corners are loaded, and in which
// directions, so that a traction on one side of a body does not go round its edges; where no face is loaded at all of
// its corners, by their areas.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sim/mesh/mid_edges.h"
#include "sim/model/model.h"

namespace fascia {

/// The traction on a face, which is quadratic there.
struct FaceLoad {
  std::array<std::uint32_t, 6> vertices;    // corners a, b, c, and the middles of ab, bc, ca
  std::array<Eigen::Vector3d, 6> traction;  // there [Pa]
  double area;                              // at rest [m^2]
};

/// The vertex, or any number, in the middle of each edge, by its ends in ascending order.
using Middles = std::map<std::array<std::uint32_t, 2>, std::uint32_t>;
Middles middles_of(const std::vector<MidEdge>& edges);

/// [vertex_count] the field at the corner vertices of the tets in `tets`, held ones included [m/s^2]. `forces`
/// [vertex_count]: on the functions L_a [N].
std::vector<Eigen::Vector3d> spread_field(const Model& model, const std::vector<std::uint32_t>& tets,
                                          const Middles& middles, const std::vector<Eigen::Vector3d>& forces);

/// The tractions on the surface of these tets with the same work as the forces at its vertices that are not held:
/// those on quadratic functions, or on linear ones with `linear`, whose middles have no forces.
std::vector<FaceLoad> spread_on_faces(const Model& model, const std::vector<std::uint32_t>& tets,
                                      const Middles& middles, const std::vector<char>& held,
                                      const std::vector<Eigen::Vector3d>& forces, bool linear);

/// The same tractions on the faces of tets that are cut in eight.
std::vector<FaceLoad> on_finer_faces(const std::vector<FaceLoad>& loads, const Model& finer,
                                     const Middles& finer_middles);

/// [of load.vertices] the forces on the quadratic functions of a face [N].
std::array<Eigen::Vector3d, 6> forces_of(const FaceLoad& load);

}  // namespace fascia
