// Writes VTK legacy files: version 3.0 in text, the layout that every VTK reads.
#include "base/number_text.h"
#include "sim/mesh/io/vtk/vtk.h"

namespace fascia {
namespace {

/// Names cannot contain spaces; VTK writes them as %20 and so on.
std::string encoded(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c > ' ' && c <= '~' && c != '"' && c != '%') {
      out += c;
    } else {
      constexpr std::string_view digits = "0123456789ABCDEF";
      const auto byte = static_cast<unsigned char>(c);
      out += {'%', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return out;
}

}  // namespace

std::string vtk_legacy_text(const TetMesh& mesh) {
  NumberText out;
  out.add("# vtk DataFile Version 3.0\ntetrahedral mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n");
  out.add("POINTS ").add(mesh.positions.size()).add(" double\n");
  for (const Eigen::Vector3d& x : mesh.positions) out.add(x[0]).add(' ').add(x[1]).add(' ').add(x[2]).add('\n');
  const auto is_quadratic = [&](std::size_t t) { return !mesh.mid_edges.empty() && mesh.mid_edges[t] != kNoMidEdges; };
  std::size_t numbers = 5 * mesh.tets.size();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) numbers += is_quadratic(t) ? 6 : 0;
  out.add("CELLS ").add(mesh.tets.size()).add(' ').add(numbers).add('\n');
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    out.add(is_quadratic(t) ? "10" : "4");
    for (const std::uint32_t v : mesh.tets[t]) out.add(' ').add(v);
    if (is_quadratic(t))
      for (const std::uint32_t v : mesh.mid_edges[t]) out.add(' ').add(v);
    out.add('\n');
  }
  out.add("CELL_TYPES ").add(mesh.tets.size()).add('\n');
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) out.add(is_quadratic(t) ? "24\n" : "10\n");
  if (!mesh.region_names.empty()) {
    out.add("FIELD FieldData ").add(mesh.region_names.size()).add('\n');
    for (const auto& [region, name] : mesh.region_names) {
      out.add(vtk_region_name_prefix).add(encoded(name)).add(" 1 1 int\n").add(region).add('\n');
    }
  }
  out.add("CELL_DATA ").add(mesh.tets.size()).add("\nSCALARS region int 1\nLOOKUP_TABLE default\n");
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) out.add(region_of(mesh, t)).add('\n');

  const auto groups = groups_beyond_regions(mesh);
  if (groups.empty()) return out.take();
  out.add("POINT_DATA ").add(mesh.positions.size()).add("\nFIELD groups ").add(groups.size()).add('\n');
  for (const auto& [name, vertices] : groups) {
    out.add(vtk_group_prefix).add(encoded(name)).add(" 1 ").add(mesh.positions.size()).add(" unsigned_char\n");
    std::string member(2 * mesh.positions.size(), '\n');
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) member[2 * v] = '0';
    for (const std::uint32_t v : *vertices) member[2 * std::size_t{v}] = '1';
    out.add(member);
  }
  return out.take();
}

}  // namespace fascia
