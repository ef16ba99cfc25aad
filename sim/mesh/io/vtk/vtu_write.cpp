#include "sim/mesh/io/vtk/vtu_write.h"

#include <bit>

#include "base/byte_text.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/vtk/vtk.h"

namespace fascia {
namespace {

void add_array(std::string& out, const VtuArray& array) {
  out += "<DataArray type=\"" + std::string(array.type) + "\" Name=\"" + xml_escaped(array.name) + "\"";
  if (array.components.size() > 1) {
    out += " NumberOfComponents=\"" + std::to_string(array.components.size()) + "\"";
    for (std::size_t i = 0; i < array.components.size(); ++i) {
      out += " ComponentName" + std::to_string(i) + "=\"" + std::string(array.components[i]) + "\"";
    }
  }
  const std::uint64_t size = array.bytes.size();
  std::string data(reinterpret_cast<const char*>(&size), sizeof size);
  data += array.bytes;
  out += " format=\"binary\">" + base64_encoded(data) + "</DataArray>\n";
}

void add_data(std::string& out, const std::string& element, const std::vector<VtuArray>& arrays) {
  out += "<" + element + ">\n";
  for (const VtuArray& array : arrays) add_array(out, array);
  out += "</" + element + ">\n";
}

struct Cells {
  std::vector<std::uint32_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
};

Cells cells_of(const VtuGrid& grid) {
  constexpr std::uint8_t kFourNodes = 10, kTenNodes = 24;
  Cells cells;
  cells.connectivity.reserve(4 * grid.tets.size() + 6 * grid.mid_edges.size());
  for (std::size_t t = 0; t < grid.tets.size(); ++t) {
    cells.connectivity.insert(cells.connectivity.end(), grid.tets[t].begin(), grid.tets[t].end());
    const bool quadratic = !grid.mid_edges.empty() && grid.mid_edges[t] != kNoMidEdges;
    if (quadratic)
      cells.connectivity.insert(cells.connectivity.end(), grid.mid_edges[t].begin(), grid.mid_edges[t].end());
    cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
    cells.types.push_back(quadratic ? kTenNodes : kFourNodes);
  }
  return cells;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;  // XML has no other control characters
    }
  }
  return out;
}

std::string vtu_text(const VtuGrid& grid) {
  static const std::vector<std::string_view> scalar = {""}, xyz = {"x", "y", "z"};
  const Cells cells = cells_of(grid);

  const bool little = std::endian::native == std::endian::little;
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"";
  out += little ? "LittleEndian" : "BigEndian";
  out += "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  if (!grid.field_arrays.empty()) {
    out += "<FieldData>\n";
    for (const VtuArray& array : grid.field_arrays) {
      std::string text;
      add_array(text, array);
      out += text.insert(std::string_view("<DataArray").size(), " NumberOfTuples=\"1\"");
    }
    out += "</FieldData>\n";
  }
  out += "<Piece NumberOfPoints=\"" + std::to_string(grid.points.size()) + "\" NumberOfCells=\"" +
         std::to_string(grid.tets.size()) + "\">\n";
  add_data(out, "PointData", grid.point_arrays);
  add_data(out, "CellData", grid.cell_arrays);
  add_data(out, "Points", {{"Points", "Float64", xyz, bytes_of(grid.points)}});
  add_data(out, "Cells",
           {{"connectivity", "UInt32", scalar, bytes_of(cells.connectivity)},
            {"offsets", "Int64", scalar, bytes_of(cells.offsets)},
            {"types", "UInt8", scalar, bytes_of(cells.types)}});
  return out + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

VtuNames::VtuNames(const TetMesh& mesh) {
  for (const auto& [region, name] : mesh.region_names) regions_.emplace_back(name, std::vector<std::int32_t>{region});
  for (const auto& [name, vertices] : groups_beyond_regions(mesh)) {
    std::vector<std::uint8_t> members(mesh.positions.size(), 0);
    for (const std::uint32_t v : *vertices) members[v] = 1;
    groups_.emplace_back(name, std::move(members));
  }
}

void VtuNames::add_to(VtuGrid& grid) const {
  static const std::vector<std::string_view> scalar = {""};
  for (const auto& [name, number] : regions_)
    grid.field_arrays.push_back({std::string(vtk_region_name_prefix) + name, "Int32", scalar, bytes_of(number)});
  for (const auto& [name, members] : groups_)
    grid.point_arrays.push_back({std::string(vtk_group_prefix) + name, "UInt8", scalar, bytes_of(members)});
}

std::string vtu_text(const TetMesh& mesh) {
  static const std::vector<std::string_view> scalar = {""};
  VtuGrid grid{mesh.positions, mesh.tets, mesh.mid_edges, {}, {}, {}};
  std::vector<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  regions.resize(mesh.tets.size(), 0);
  grid.cell_arrays.push_back({"region", "Int32", scalar, bytes_of(regions)});

  const VtuNames names(mesh);
  names.add_to(grid);
  return vtu_text(grid);
}

}  // namespace fascia
