// Writes the findings of the surface check.
#include <algorithm>
#include <ostream>

#include "base/error.h"
#include "base/text.h"
#include "sim/surface/surface_repair.h"

namespace fascia {
namespace {

// A surface with larger holes has no well-defined inside. A tube that is open at both ends has 1/7 at 14 radii.
constexpr double kLargestHoles = 0.2;  // of the area
// A surface that is mostly walls between cells, each present once, has an inside only if the cells are known.
constexpr double kLargestWalls = 0.5;  // of the area
constexpr std::size_t kNamedShells = 8;
constexpr const char* kExpected = "expected a closed surface, to be filled with tets";

std::string percent(double share) { return number(100 * share) + " %"; }

std::string found(const SurfaceFinding& finding, const char* noun) {
  return plural(finding.count, noun) + (finding.count == 1 ? " at " : ", the first at ") + point(finding.first);
}

std::size_t count_shells(const SurfaceReport& report, bool SurfaceShell::*kind) {
  return static_cast<std::size_t>(std::count_if(report.shells.begin(), report.shells.end(),
                                                [&](const SurfaceShell& shell) { return shell.*kind; }));
}

}  // namespace

void require_fillable(const SurfaceRepair& repaired, const std::string& where) {
  const SurfaceReport& report = repaired.report;
  if (repaired.triangles.empty()) throw Error(where, "has no triangle with area", kExpected);
  if (report.one_sided.count > 0)
    throw Error(
        where, "is one-sided: no turning of its triangles agrees at " + found(report.one_sided, "edge"),
        "expected a surface with an inside, no Moebius strip or Klein bottle: take out or turn the triangles there");
  double flat_area = 0;
  for (const SurfaceShell& shell : report.shells) flat_area += shell.flat ? shell.area : 0;
  if (repaired.closed() && !repaired.balanced && flat_area > kLargestWalls * report.area)
    throw Error(where,
                "has walls inside: " + found(report.crowded_edges, "edge") + " of more than two triangles, " +
                    percent(flat_area / report.area) + " of its area bounds nothing",
                "expected a closed surface, without the faces between cells");
  if (report.hole_area > kLargestHoles * report.area)
    throw Error(where,
                "is open: " + found(report.open_edges, "edge") + " of one triangle only, " +
                    plural(report.holes, "hole") + " of " + percent(report.hole_area / report.area) + " of its area",
                "expected a closed surface, or holes of at most " + percent(kLargestHoles) +
                    ": fill the holes in the program that made the file, or, where the surface is a thin wall, give "
                    "that wall a thickness there");
  // The volume of a sheet with two sides is only rounding.
  if (!(std::abs(report.volume) > 1e-9 * std::pow(report.area, 1.5)))
    throw Error(where, "encloses no volume (" + number(report.volume) + " in an area of " + number(report.area) + ")",
                kExpected);
}

std::vector<std::string> notes_of(const SurfaceReport& report) {
  std::vector<std::string> notes;
  if (report.degenerate.count > 0) notes.push_back(found(report.degenerate, "triangle") + ", without area: left out");
  if (report.duplicates.count > 0)
    notes.push_back(found(report.duplicates, "triangle") + ", with the vertices of an earlier one: left out");
  if (report.walls.count > 0)
    notes.push_back(found(report.walls, "triangle") + ", walls between two cells, there both ways round: left out");
  if (report.turned.count > 0) notes.push_back(found(report.turned, "triangle") + ", wound against the others: turned");
  if (const std::size_t count = count_shells(report, &SurfaceShell::inverted); count > 0)
    notes.push_back(count == report.shells.size() ? "normals pointed inward: turned"
                                                  : plural(count, "shell") + " of " +
                                                        std::to_string(report.shells.size()) + " inside out: turned");
  constexpr double kSeam = 1e-9;  // of the area: between sides whose vertices differ by rounding
  if (report.open_edges.count > 0 && report.hole_area < kSeam * report.area)
    notes.push_back(found(report.open_edges, "open edge") + ", along a seam without width: closed for the tets");
  else if (report.open_edges.count > 0)
    notes.push_back(plural(report.holes, "hole") + " of " + percent(report.hole_area / report.area) + " of the area (" +
                    found(report.open_edges, "open edge") + "): closed for the tets");
  if (report.crowded_edges.count > 0)
    notes.push_back(found(report.crowded_edges, "edge") + ", of more than two triangles: filled by what lies inside");
  return notes;
}

void print_report(std::ostream& out, const SurfaceMesh& surface, const SurfaceRepair& repaired, const std::string& unit,
                  const Progress& progress) {
  const SurfaceReport& report = repaired.report;
  line(out, "format") << surface.format << " surface\n";
  line(out, "vertices") << report.vertices;
  if (report.welded > 0) out << ", " << report.welded << " of them at the place of another one";
  out << "\n";
  line(out, "triangles") << report.triangles << "\n";
  if (!report.box.isEmpty()) {
    const Eigen::Vector3d size = report.box.sizes();
    line(out, "box") << number(size.x()) << " x " << number(size.y()) << " x " << number(size.z()) << " " << unit
                     << ", from " << point(report.box.min()) << " to " << point(report.box.max()) << "\n";
  }
  line(out, "area") << number(report.area) << " " << unit << "^2\n";
  line(out, "volume") << number(report.volume) << " " << unit << "^3\n";
  line(out, "closed") << (repaired.closed()
                              ? "yes"
                              : "no: " + found(report.open_edges, "open edge") + ", " + plural(report.holes, "hole"))
                      << "\n";
  line(out, "shells") << report.shells.size();
  if (const std::size_t cavities = count_shells(report, &SurfaceShell::cavity); cavities > 0)
    out << ", " << cavities << (cavities == 1 ? " of them a cavity" : " of them cavities");
  out << "\n";
  if (report.shells.size() > 1) {
    for (std::size_t s = 0; s < std::min(report.shells.size(), kNamedShells); ++s) {
      const SurfaceShell& shell = report.shells[s];
      line(out, "") << plural(shell.triangles, "triangle") << ", " << number(shell.volume) << " " << unit << "^3"
                    << (shell.cavity ? ", a cavity" : "") << "\n";
    }
    if (report.shells.size() > kNamedShells)
      line(out, "") << "and " << report.shells.size() - kNamedShells << " smaller ones\n";
  }
  const SelfIntersections cuts = self_intersections(TriangleTree(repaired.positions, repaired.triangles), progress);
  line(out, "cuts itself") << (cuts.pairs.count > 0 ? "in " + found(cuts.pairs, "pair") + " of triangles" +
                                                          (cuts.complete ? "" : " and perhaps more") +
                                                          ": harmless, filled by what lies inside"
                               : cuts.complete
                                   ? "nowhere"
                                   : "perhaps: too many triangles lie across each other to look at all pairs")
                           << "\n";
  for (const SurfaceMaterial& material : surface.materials) {
    constexpr const char* kHex = "0123456789abcdef";
    std::string color = "#";
    for (const int shift : {0, 8, 16}) {
      color += kHex[material.color >> (shift + 4) & 15];
      color += kHex[material.color >> shift & 15];
    }
    line(out, "material") << material.name << "  " << color << ", " << plural(material.triangles, "triangle") << "\n";
  }
  if (surface.vertex_colors) line(out, "colors") << "of the vertices\n";
  for (const std::string& note : surface.notes) line(out, "note") << note << "\n";
  for (const std::string& note : notes_of(report)) line(out, "note") << note << "\n";
}

}  // namespace fascia
