#include "sim/surface/surface_fill.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/error.h"
#include "base/text.h"
#include "sim/surface/shape_file.h"

namespace fascia {
namespace {

constexpr double kWantedTets = 7000, kMostTets = 4e6;
// Tets of a lattice of spacing h: 12 per cube of the inside, and for each square of the surface about the number
// counted on tori of 10 to 40 cells (1.4 to 2).
constexpr double kTetsInside = 12, kTetsOnSurface = 1.5;

double expected_tets(const SurfaceReport& report, double spacing) {
  return kTetsInside * std::abs(report.volume) / std::pow(spacing, 3) +
         kTetsOnSurface * report.area / std::pow(spacing, 2);
}

int resolution_for(const SurfaceReport& report, double tets) {
  const double longest = report.box.sizes().maxCoeff();
  int cells = kFewestCells;
  while (cells < kMostCells && expected_tets(report, longest / (cells + 1)) <= tets) ++cells;
  return cells;
}

/// A resolution with two cells across the parts of mean thickness, if the surface allows it. A tube of radius r has
/// V / A = r / 2, a sheet of thickness t has t / 2.
std::string remedy_for_thin_parts(const SurfaceReport& report, int resolution) {
  const double longest = report.box.sizes().maxCoeff(), spacing = 2 * std::abs(report.volume) / report.area;
  const int most = resolution_for(report, kMostTets);
  const int fine = static_cast<int>(std::fmin(std::fmax(std::ceil(longest / spacing), resolution + 1), kMostCells));
  if (resolution >= most) return "no finer resolution is possible: thicken the thin parts, or make the tets elsewhere";
  const int chosen = std::min(fine, most);
  const long thousands = std::max(1L, std::lround(expected_tets(report, longest / chosen) / 1000));
  return "--set resolution=" + std::to_string(chosen) + " is finer (about " + std::to_string(1000 * thousands) +
         " tets)";
}

/// How often the surface encloses its inside, on average. Where it overlaps itself the report adds up volume
/// that is filled once.
double multiplicity(const TriangleTree& surface, const std::vector<Eigen::Vector3d>& x, const std::vector<Tet>& tets) {
  constexpr std::size_t kSamples = 2000;
  double inside = 0, enclosed = 0;
  for (std::size_t t = 0; t < tets.size(); t += 1 + tets.size() / kSamples) {
    const Tet& v = tets[t];
    const double winding = std::round(surface.winding((x[v[0]] + x[v[1]] + x[v[2]] + x[v[3]]) / 4));
    if (winding < 1) continue;
    const double volume = signed_volume6(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    inside += volume;
    enclosed += winding * volume;
  }
  return inside > 0 ? enclosed / inside : 1;
}

MeshFile as_mesh(LatticeFill fill) {
  MeshFile file;
  file.format = "tets in a surface";
  file.mesh.positions = std::move(fill.positions);
  file.mesh.tets = std::move(fill.tets);
  file.mesh.regions.assign(file.mesh.tets.size(), 0);
  return file;
}

}  // namespace

FilledSurface fill_surface(SurfaceMesh surface, const std::string& where, std::optional<int> resolution,
                           const Progress& progress) {
  FilledSurface filled;
  filled.repaired = repair(surface, part_of(progress, 0, 0.2));
  require_fillable(filled.repaired, where);
  const SurfaceReport& found = filled.repaired.report;
  filled.resolution = resolution.value_or(resolution_for(found, kWantedTets));
  const double expected = expected_tets(found, found.box.sizes().maxCoeff() / filled.resolution);
  if (expected > kMostTets)
    throw Error(where,
                "a resolution of " + std::to_string(filled.resolution) + " makes about " + number(expected / 1e6) +
                    " million tets",
                "expected at most " + std::to_string(resolution_for(found, kMostTets)) + " for this surface");
  const TriangleTree tree(filled.repaired.positions, filled.repaired.triangles);
  LatticeFill fill = fill_inside(tree, filled.repaired.balanced, filled.resolution, part_of(progress, 0.2, 1));
  if (fill.tets.empty())
    throw Error(where, "holds no tet at a resolution of " + std::to_string(filled.resolution), "expected a higher one");
  const std::size_t whole = fill.whole, apart = fill.apart;
  const double overlap = multiplicity(tree, fill.positions, fill.tets);
  filled.file = as_mesh(std::move(fill));
  filled.file.notes = notes_of(found);
  filled.file.notes.insert(filled.file.notes.begin(), surface.notes.begin(), surface.notes.end());
  filled.notes_of_surface = std::ssize(filled.file.notes);
  constexpr double kOverlap = 1.005;
  if (overlap > kOverlap)
    filled.file.notes.push_back("the surface overlaps itself, and what it encloses several times is filled once (" +
                                number(100 * (1 - 1 / overlap)) +
                                " % of its volume); a shell is a cavity if its triangles are reversed");
  double volume = 0;
  const auto& x = filled.file.mesh.positions;
  for (const Tet& t : filled.file.mesh.tets) volume += signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6;
  const double ratio = overlap * volume / found.volume;
  filled.file.filled = ratio;
  if (whole > 0) {
    // A sharp edge is thinner than any lattice: only a visible difference is reported, and a part as long as a cell.
    constexpr double kVolume = 0.02, kShare = 0.1;
    constexpr std::size_t kApart = 12;  // tets of a cell
    const double share = static_cast<double>(whole) / static_cast<double>(filled.file.mesh.tets.size());
    const bool notable = std::abs(ratio - 1) > kVolume || share > kShare || apart >= kApart;
    if (notable)
      filled.file.notes.push_back(
          "parts are thinner than the lattice's cells, 1/" + std::to_string(filled.resolution) +
          " of the longest side: " + plural(whole, "tet") + " kept whole there, the tets have " + number(ratio) +
          " times the volume of the surface; " + remedy_for_thin_parts(found, filled.resolution));
  }
  put_right(surface, filled.repaired);
  filled.surface = std::move(surface);
  return filled;
}

MeshFile read_mesh_or_fill(const std::filesystem::path& path, std::optional<int> resolution, const Progress& progress) {
  ShapeFile shape = read_shape(path, part_of(progress, 0, 0.1));
  if (!shape.surface) return std::move(shape.tets);
  return fill_surface(std::move(*shape.surface), path.string(), resolution, part_of(progress, 0.1, 1)).file;
}

}  // namespace fascia
