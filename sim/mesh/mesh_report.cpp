// Writes the findings of the mesh check: one labeled line per finding, numbers with their units, bad tets by their
// index.
#include <ostream>
#include <span>
#include <sstream>

#include "base/text.h"
#include "sim/mesh/mesh_check.h"

namespace fascia {
namespace {

constexpr std::size_t kNamedVertices = 3;
// From the smallest sample under a microscope to the largest whole body.
constexpr double kSmallestTissue = 1e-3, kLargestTissue = 3;  // [m]

/// "degenerate  3 tets left out: ...: 0, 7, 12"; no line if the list is empty.
void print_tets(std::ostream& out, const char* label, const std::vector<std::uint32_t>& tets, const char* what) {
  if (tets.empty()) return;
  line(out, label) << plural(tets.size(), "tet") << " " << what << ": ";
  for (std::size_t k = 0; k < tets.size() && k < kNamedTets; ++k) out << (k ? ", " : "") << tets[k];
  if (tets.size() > kNamedTets) out << " and " << tets.size() - kNamedTets << " more";
  out << "\n";
}

void print_far(std::ostream& out, const TetMesh& mesh, const std::vector<std::uint32_t>& vertices) {
  if (vertices.empty()) return;
  line(out, "far off") << vertices.size() << (vertices.size() == 1 ? " vertex" : " vertices")
                       << " far from all others: ";
  for (std::size_t k = 0; k < vertices.size() && k < kNamedVertices; ++k)
    out << (k ? ", " : "") << vertices[k] << " at " << point(mesh.positions[vertices[k]]);
  if (vertices.size() > kNamedVertices) out << " and " << vertices.size() - kNamedVertices << " more";
  out << "\n";
}

void print_slivers(std::ostream& out, const MeshReport& report) {
  if (report.slivers == 0) return;
  line(out, "slivers") << plural(report.slivers, "tet") << " with a dihedral angle below 5 degrees: ";
  for (std::size_t k = 0; k < report.worst_slivers.size(); ++k) {
    const MeshReport::Sliver& sliver = report.worst_slivers[k];
    out << (k ? ", " : "") << sliver.tet << " (" << number(sliver.smallest_dihedral_deg) << ")";
  }
  if (report.slivers > report.worst_slivers.size()) {
    out << " and " << report.slivers - report.worst_slivers.size() << " more";
  }
  out << "\n";
}

void print_shape(std::ostream& out, const MeshReport& report, const std::string& unit) {
  const Eigen::Vector3d size = report.box_max - report.box_min;
  line(out, "box") << number(size.x()) << " x " << number(size.y()) << " x " << number(size.z()) << " " << unit
                   << ", from " << point(report.box_min) << " to " << point(report.box_max) << "\n";
  line(out, "volume") << number(report.volume) << " " << unit << "^3\n";
  line(out, "edges") << length_in(unit, report.shortest_edge) << " to " << length_in(unit, report.longest_edge) << "\n";
  line(out, "dihedral") << number(report.smallest_dihedral_deg) << " to " << number(report.largest_dihedral_deg)
                        << " degrees between the faces of a tet\n";
  line(out, "components") << report.components
                          << (report.components > 1 ? ", which share no vertex and so move independently\n" : "\n");
  line(out, "boundary") << plural(report.boundary_triangles, "triangle");
  if (report.boundary_manifold) {
    out << ", manifold\n";
  } else {
    out << ", not manifold: " << plural(report.nonmanifold_edges, "edge") << " not between two triangles, "
        << report.nonmanifold_vertices << (report.nonmanifold_vertices == 1 ? " vertex" : " vertices")
        << " with more than one fan of triangles\n";
  }
}

void print_regions(std::ostream& out, const std::vector<MeshReport::Region>& regions, const std::string& unit) {
  std::size_t name_width = 0;
  for (const MeshReport::Region& region : regions) name_width = std::max(name_width, region.name.size());
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const MeshReport::Region& region = regions[k];
    line(out, k == 0 ? "regions" : "") << region.number << "  " << region.name
                                       << std::string(name_width - region.name.size() + (name_width ? 2 : 0), ' ')
                                       << plural(region.tets, "tet") << ", " << number(region.volume) << " " << unit
                                       << "^3\n";
  }
}

void print_groups(std::ostream& out, const TetMesh& mesh) {
  const char* label = "groups";
  for (const auto& [name, vertices] : mesh.groups) {
    line(out, label) << name << ": " << vertices.size() << (vertices.size() == 1 ? " vertex\n" : " vertices\n");
    label = "";
  }
}

struct UnitGuess {
  const char* question;
  double scale;
};
constexpr UnitGuess kTooLarge[] = {
    {"made in millimeters?", 1e-3}, {"in centimeters?", 1e-2}, {"in micrometers?", 1e-6}};
constexpr UnitGuess kTooSmall[] = {{"converted from millimeters twice?", 1e3},
                                   {"converted from micrometers twice?", 1e6}};

bool is_tissue(double extent) { return extent >= kSmallestTissue && extent <= kLargestTissue; }

/// Units that result in the size of tissue, the most likely first.
std::vector<UnitGuess> unit_guesses(double extent) {
  std::vector<UnitGuess> guesses;
  if (extent == 0 || is_tissue(extent)) return guesses;
  const bool large = extent > kLargestTissue;
  for (const UnitGuess& guess : large ? std::span<const UnitGuess>(kTooLarge) : std::span<const UnitGuess>(kTooSmall))
    if (is_tissue(extent * guess.scale)) guesses.push_back(guess);
  return guesses;
}

}  // namespace

std::string ignored_cells(const MeshFile& file) {
  std::string list;
  const auto add = [&](std::size_t count, const char* noun) {
    if (count > 0) list += (list.empty() ? "" : ", ") + plural(count, noun);
  };
  add(file.ignored.points, "point");
  add(file.ignored.lines, "line");
  add(file.ignored.triangles, "triangle");
  add(file.ignored.polygons, "polygon");
  add(file.ignored.others, "other cell");
  return list;
}

std::string guess_unit(double extent, double scale) {
  if (extent == 0 || is_tissue(extent)) return "";
  std::string advice;
  for (const UnitGuess& guess : unit_guesses(extent))
    advice += std::string(advice.empty() ? "was the file " : "; or ") + guess.question +
              " try --set bodies.0.transform.scale=" + number(guess.scale * scale) + " (" +
              length(extent * guess.scale) + " wide)";
  if (advice.empty()) advice = "for 10 cm, try --set bodies.0.transform.scale=" + number(0.1 / extent * scale);
  return length(extent) + " wide, too " + (extent > kLargestTissue ? "large" : "small") + " for tissue: " + advice;
}

double scale_to_meters(double extent) {
  const std::vector<UnitGuess> guesses = unit_guesses(extent);
  return guesses.empty() ? 1 : guesses.front().scale;
}

void print_report(std::ostream& out, const MeshFile& file, const MeshRepair& repaired, const MeshReport& report,
                  const std::string& unit) {
  line(out, "format") << file.format << "\n";
  line(out, "vertices") << report.vertex_count;
  if (report.unused_vertices > 0) out << ", " << report.unused_vertices << " of them in no usable tet";
  if (report.coincident_vertices > 0)
    out << ", " << report.coincident_vertices
        << " of them at the place of an earlier one, not joined: convert --weld makes them one";
  out << "\n";
  line(out, "tets") << report.tet_count;
  if (report.usable_tets != report.tet_count) out << ", " << report.usable_tets << " of them usable";
  out << "\n";
  if (report.usable_tets > 0) print_shape(out, report, unit);
  print_regions(out, report.regions, unit);
  print_groups(out, file.mesh);
  print_tets(out, "flipped", repaired.flipped, "wound inside out, reoriented");
  print_tets(out, "degenerate", repaired.degenerate, "lower than 1e-7 of the longest edge, left out");
  print_tets(out, "duplicated", repaired.duplicated, "with the vertices of an earlier one, left out");
  print_far(out, file.mesh, report.far_vertices);
  print_slivers(out, report);
  if (const std::string cells = ignored_cells(file); !cells.empty()) line(out, "ignored") << cells << "\n";
  for (const std::string& note : file.notes) line(out, "note") << note << "\n";
  if (!report.unit_guess.empty()) line(out, "size") << report.unit_guess << "\n";
}

}  // namespace fascia
