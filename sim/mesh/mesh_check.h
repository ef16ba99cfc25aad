// Finds the defects of a mesh and repairs those whose repair does not change the meaning of the file.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim/mesh/mesh_file.h"

namespace fascia {

struct MeshRepair {
  std::vector<Tet> tets;                  // [n] usable tets, every one of positive volume
  std::vector<std::uint32_t> source;      // [n] index of each usable tet in the file
  std::vector<std::uint32_t> flipped;     // file indices of tets that were reoriented (they are in `tets`)
  std::vector<std::uint32_t> degenerate;  // file indices left out: repeated vertices, or height below 1e-7 of\nthe
                                          // longest edge, below which float32 has no accuracy left
  std::vector<std::uint32_t> duplicated;  // file indices left out: the same four vertices as an earlier tet
};
MeshRepair repair(const TetMesh& mesh);

/// The number of tets of each kind that messages name.
inline constexpr std::size_t kNamedTets = 10;

struct MeshReport {
  std::size_t vertex_count = 0, tet_count = 0, usable_tets = 0, flipped = 0, degenerate = 0, duplicated = 0;
  std::vector<std::uint32_t> far_vertices;  // see sim/mesh/vertex_check.h
  // The members below refer to the usable tets and their vertices.
  std::size_t unused_vertices = 0, components = 0;  // component: tets connected through shared vertices
  std::size_t coincident_vertices = 0;              // at the position of an earlier one
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero(), box_max = Eigen::Vector3d::Zero();  // [m]
  double volume = 0, shortest_edge = 0, longest_edge = 0;                                // [m^3], [m], [m]
  double smallest_dihedral_deg = 0, largest_dihedral_deg = 0;
  std::size_t slivers = 0;  // tets whose smallest dihedral angle is below 5 degrees
  struct Sliver {
    std::uint32_t tet;  // index in the file
    double smallest_dihedral_deg;
  };
  std::vector<Sliver> worst_slivers;  // at most kNamedTets, the worst first
  bool boundary_manifold = false;     // a closed surface, or several
  std::size_t boundary_triangles = 0;
  std::size_t nonmanifold_edges = 0;     // edges without exactly two boundary triangles
  std::size_t nonmanifold_vertices = 0;  // vertices whose boundary triangles form more than one fan
  struct Region {
    int number;
    std::string name;
    std::size_t tets;
    double volume;  // [m^3]
  };
  std::vector<Region> regions;  // ascending numbers
  std::string unit_guess;  // empty if the size is plausible in meters, else advice: "6.5 m wide: ... try --set ..."
};
MeshReport examine(const TetMesh& mesh, const MeshRepair& repaired);

/// Advice for a mesh whose largest extent [m], times `scale`, is not a plausible size of tissue, in words and as a
/// --set; empty if it is plausible.
std::string guess_unit(double extent, double scale = 1);

/// The scale that gives a mesh of this largest extent [m] the size of tissue, assuming another unit in the file; 1 if
/// there is none.
double scale_to_meters(double extent);

/// The text of `fascia info` for one mesh with coordinates in `unit`; names at most kNamedTets of each kind.
void print_report(std::ostream& out, const MeshFile& file, const MeshRepair& repaired, const MeshReport& report,
                  const std::string& unit = "m");

}  // namespace fascia
