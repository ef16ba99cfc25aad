// What is wrong with a surface that is to be filled with tets, and what can be put right without asking: where it is
// open, how it is wound, of how many shells it is made.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/surface/surface_mesh.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {

/// How often, and where the first one is.
struct SurfaceFinding {
  std::size_t count = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  // [m]
  void add(const Eigen::Vector3d& where);
};

/// Triangles that are connected over edges of exactly two of them.
struct SurfaceShell {
  std::size_t triangles = 0;
  double area = 0;        // [m^2]
  double volume = 0;      // enclosed [m^3], as repaired; negative for a cavity
  bool inverted = false;  // turned, for its normals pointed inward
  bool cavity = false;    // bounds a hole inside another shell
  bool flat = false;      // encloses nothing
};

struct SurfaceReport {
  std::size_t vertices = 0, triangles = 0;  // of the file
  std::size_t welded = 0;                   // vertices at the place of an earlier one
  Eigen::AlignedBox3d box;                  // of the triangles [m]
  double area = 0, volume = 0;              // [m^2], [m^3]
  SurfaceFinding degenerate;                // triangles without area, left out
  SurfaceFinding duplicates;                // triangles with the vertices of an earlier one, left out
  SurfaceFinding walls;                     // triangles there as often the one way round as the other, left out
  SurfaceFinding open_edges;                // of one triangle
  SurfaceFinding crowded_edges;             // of more than two
  SurfaceFinding turned;                    // triangles wound against the rest of their shell, turned
  SurfaceFinding one_sided;                 // edges at which no turning helps, as in a Moebius strip
  std::size_t holes = 0;                    // connected groups of open edges
  double hole_area = 0;                     // [m^2]
  std::vector<SurfaceShell> shells;         // the largest first
};

struct SurfaceRepair {
  std::vector<Eigen::Vector3d> positions;  // of the file
  std::vector<Triangle> triangles;         // outward, cavities inward; vertices at one place are one
  std::vector<char> turned;                // [triangle of the file] 1 where its winding was turned
  std::vector<char> left_out;              // [triangle of the file] 1 where it has no area or is there already
  SurfaceReport report;
  bool closed() const { return report.open_edges.count == 0; }
  bool balanced = false;  // closed, and each edge of several triangles is passed as often one way as the other
};

SurfaceRepair repair(const SurfaceMesh& surface, const Progress& progress = {});

/// The surface as it is to be drawn: wound outward, each triangle once, and known to be closed or not. Its vertices
/// stay as they are.
void put_right(SurfaceMesh& surface, const SurfaceRepair& repaired);

struct SelfIntersections {
  SurfaceFinding pairs;  // of triangles that cut each other, the first at one of the cuts
  bool complete = true;  // false: so many boxes overlap that the search was given up
};
/// The tree's triangles share vertices where they touch.
SelfIntersections self_intersections(const TriangleTree& tree, const Progress& progress = {});

/// Throws Error, with `where` before it, if the surface encloses no inside that tets could fill.
void require_fillable(const SurfaceRepair& repaired, const std::string& where);

/// What was put right or is closed without asking, one sentence each.
std::vector<std::string> notes_of(const SurfaceReport& report);

/// The text of `fascia info` about a surface.
void print_report(std::ostream& out, const SurfaceMesh& surface, const SurfaceRepair& repaired,
                  const Progress& progress = {});

}  // namespace fascia
