// Finds the defects of a surface that is to be filled with tets, and repairs those with an unambiguous repair: open
// edges, winding, shells.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/surface/surface_mesh.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {

/// The number of findings, and the place of the first.
struct SurfaceFinding {
  std::size_t count = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  // [m]
  void add(const Eigen::Vector3d& where);
};

/// Triangles that are connected through edges of exactly two of them.
struct SurfaceShell {
  std::size_t triangles = 0;
  double area = 0;        // [m^2]
  double volume = 0;      // enclosed [m^3], as repaired; negative for a cavity
  bool inverted = false;  // reversed, because its normals pointed inward
  bool cavity = false;    // bounds a hole inside another shell
  bool flat = false;      // encloses no volume
};

struct SurfaceReport {
  std::size_t vertices = 0, triangles = 0;  // of the file
  std::size_t welded = 0;                   // vertices at the position of an earlier one
  Eigen::AlignedBox3d box;                  // of the triangles [m]
  double area = 0, volume = 0;              // [m^2], [m^3]
  SurfaceFinding degenerate;                // triangles without area, removed
  SurfaceFinding duplicates;                // triangles with the vertices of an earlier one, removed
  SurfaceFinding walls;                     // triangles that occur equally often in both orientations, removed
  SurfaceFinding open_edges;                // edges of one triangle
  SurfaceFinding crowded_edges;             // edges of more than two triangles
  SurfaceFinding turned;                    // triangles wound against the rest of their shell, reversed
  SurfaceFinding one_sided;                 // edges that no reversal makes consistent, as in a Moebius strip
  std::size_t holes = 0;                    // connected groups of open edges
  double hole_area = 0;                     // [m^2]
  std::vector<SurfaceShell> shells;         // the largest first
};

struct SurfaceRepair {
  std::vector<Eigen::Vector3d> positions;  // of the file
  std::vector<Triangle> triangles;         // outward, cavities inward; vertices at one position are merged
  std::vector<char> turned;                // [triangle of the file] 1 where its winding was reversed
  std::vector<char> left_out;              // [triangle of the file] 1 where it has no area or is a duplicate
  SurfaceReport report;
  bool closed() const { return report.open_edges.count == 0; }
  bool balanced = false;  // closed, and each edge of several triangles is traversed equally often in both directions
};

SurfaceRepair repair(const SurfaceMesh& surface, const Progress& progress = {});

/// Changes the surface as it will be drawn: wound outward, each triangle once, and known to be closed or not. Its
/// vertices stay unchanged.
void put_right(SurfaceMesh& surface, const SurfaceRepair& repaired);

struct SelfIntersections {
  SurfaceFinding pairs;  // pairs of triangles that cut each other; the first is at one of the cuts
  bool complete = true;  // false: the search was stopped because too many boxes overlap
};
/// The tree's triangles must share vertices where they touch.
SelfIntersections self_intersections(const TriangleTree& tree, const Progress& progress = {});

/// Throws Error, with `where` before it, if the surface encloses no inside to fill with tets.
void require_fillable(const SurfaceRepair& repaired, const std::string& where);

/// Notes about repairs and holes that were closed, one sentence each.
std::vector<std::string> notes_of(const SurfaceReport& report);

/// Prints the text of `fascia info` for a surface with coordinates in `unit`.
void print_report(std::ostream& out, const SurfaceMesh& surface, const SurfaceRepair& repaired,
                  const std::string& unit = "m", const Progress& progress = {});

}  // namespace fascia
