// A tetrahedral mesh as stored in a file: the file's vertex order, the file's tets, nothing repaired.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace fascia {

using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;

/// A quadratic tet has a vertex in the middle of each edge, in this order of edges between corners: that of VTK's cell
/// 24 and of Abaqus' C3D10.
inline constexpr std::array<std::array<std::size_t, 2>, 6> kMidEdgeCorners = {
    {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
using MidEdges = std::array<std::uint32_t, 6>;
inline constexpr std::uint32_t kNoVertex = ~0u;
inline constexpr MidEdges kNoMidEdges = {kNoVertex, kNoVertex, kNoVertex, kNoVertex, kNoVertex, kNoVertex};

struct TetMesh {
  std::vector<Eigen::Vector3d> positions;   // [vertex_count] rest positions [m], unreferenced vertices included
  std::vector<Tet> tets;                    // [tet_count] in the file's order and winding
  std::vector<MidEdges> mid_edges;          // [tet_count] kNoMidEdges in linear tets; empty if all tets are linear
  std::vector<int> regions;                 // [tet_count] region number (Gmsh physical tag, TetGen attribute); 0: none
  std::map<int, std::string> region_names;  // names of region numbers, where the file has them
  /// Vertex sets that scenes select by name: every physical group of the file, of any dimension, under its name (under
  /// its number in decimal if it has none). Ascending vertex indices.
  std::map<std::string, std::vector<std::uint32_t>> groups;
};

/// Six times the signed volume of the tet (a, b, c, d); positive when d lies on the side that b-a, c-a span
/// right-handedly.
inline double signed_volume6(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                             const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

}  // namespace fascia
