// Reading VTK XML unstructured grids (.vtu) and polygons (.vtp), in one or several pieces.
#include <algorithm>

#include "sim/mesh/io/foreign_formats.h"
#include "sim/mesh/io/vtk/vtu_array.h"

namespace fascia {
namespace {

class VtuReader {
 public:
  VtuReader(Scanner& in, MeshFile& file)
      : in_(in), root_(parse_xml(in)), arrays_(in, checked(root_)), file_(file), grid_(file) {}

  void read() {
    const XmlElement& grid = required(root_, polydata_ ? "PolyData" : "UnstructuredGrid");
    read_field_data(grid);
    required(grid, "Piece");
    for (const XmlElement& piece : grid.children) {
      if (piece.name == "Piece") read_piece(piece);
    }
    grid_.finish(in_.where());
  }

 private:
  const XmlElement& checked(const XmlElement& root) {
    if (root.name != "VTKFile") fail_at(in_, root, "is not a VTK file", "expected VTKFile");
    const std::string kind = root.attribute("type");
    polydata_ = kind == "PolyData";
    if (!polydata_ && kind != "UnstructuredGrid")
      fail_at(in_, root, "type is " + in_quotes(kind),
              "expected UnstructuredGrid or PolyData" + way_of_vtk_dataset(kind));
    return root;
  }

  const XmlElement& required(const XmlElement& parent, std::string_view name) {
    const XmlElement* const found = parent.child(name);
    if (!found) fail_at(in_, parent, "has no element " + std::string(name), "expected one");
    return *found;
  }

  const XmlElement& required_array(const XmlElement& parent, std::string_view name) {
    for (const XmlElement& array : parent.children) {
      if (array.name == "DataArray" && array.attribute("Name") == name) return array;
    }
    fail_at(in_, parent, "has no DataArray " + in_quotes(name), "expected one");
  }

  /// The next error is located in this array.
  void locate(const XmlElement& array) {
    in_.set_section("DataArray " + in_quotes(array.attribute("Name")));
    in_.blame(array.at);
  }

  std::size_t count(const XmlElement& piece, const char* key) {
    const std::uint64_t value = xml_count(in_, piece, key);
    constexpr std::uint64_t values_per_byte = 1032;  // upper bound for deflated data
    if (value / values_per_byte > in_.data().size()) {
      fail_at(in_, piece, std::string(key) + " is " + std::to_string(value),
              "expected no more than a file of " + std::to_string(in_.data().size()) + " bytes can hold");
    }
    return value;
  }

  template <class Use>
  void for_arrays(const XmlElement& parent, const char* kind, bool (*wanted)(std::string_view), Use use) {
    const XmlElement* const data = parent.child(kind);
    if (!data) return;
    for (const XmlElement& array : data->children) {
      const std::string name = array.attribute("Name");
      if (array.name == "DataArray" && array.attribute("NumberOfComponents", "1") == "1" && wanted(name))
        use(name, array);
    }
  }

  void read_field_data(const XmlElement& grid) {
    for_arrays(grid, "FieldData", VtkGrid::is_region_name, [&](const std::string& name, const XmlElement& array) {
      grid_.add_field_array(name, arrays_.values<double>(array, std::nullopt));
    });
  }

  /// The lists of polydata, in the order of cell data, and the attributes with their sizes.
  static constexpr std::pair<const char*, const char*> kLists[] = {
      {"Verts", "NumberOfVerts"}, {"Lines", "NumberOfLines"}, {"Strips", "NumberOfStrips"}, {"Polys", "NumberOfPolys"}};

  std::size_t polydata_count(const XmlElement& piece, const char* number) {
    return piece.attribute(number).empty() ? 0 : count(piece, number);
  }

  std::size_t count_polydata(const XmlElement& piece) {
    std::size_t all = 0;
    for (const auto& [list, number] : kLists) all += polydata_count(piece, number);
    return all;
  }

  /// `type`: of all cells; none if the file has a type for each.
  void read_cells(const XmlElement& lists, std::size_t cell_count, std::optional<std::int64_t> type) {
    if (type && cell_count == 0) return;  // programs leave the arrays out
    const XmlElement& connectivity = required_array(lists, "connectivity");
    VtkCells cells;
    cells.offsets = arrays_.values<std::int64_t>(required_array(lists, "offsets"), cell_count);
    cells.types = type ? std::vector<std::int64_t>(cell_count, *type)
                       : arrays_.values<std::int64_t>(required_array(lists, "types"), cell_count);
    cells.connectivity = arrays_.values<std::int64_t>(connectivity, std::nullopt);
    locate(connectivity);
    grid_.add_cells(in_, cells);
    in_.set_section("");
  }

  void read_piece(const XmlElement& piece) {
    const std::size_t point_count = count(piece, "NumberOfPoints");
    const std::size_t cell_count = polydata_ ? count_polydata(piece) : count(piece, "NumberOfCells");

    const XmlElement& points = required(required(piece, "Points"), "DataArray");
    const std::string components = points.attribute("NumberOfComponents", "3");
    if (components != "3") fail_at(in_, points, "NumberOfComponents is " + in_quotes(components), "expected 3");
    file_.format = (polydata_ ? "VTP " : "VTU ") + arrays_.encoding(points);
    const std::vector<double> coordinates = arrays_.values<double>(points, 3 * point_count, true);
    locate(points);
    grid_.add_points(in_, coordinates);
    in_.set_section("");

    if (!polydata_) read_cells(required(piece, "Cells"), cell_count, std::nullopt);
    for (const auto& [list, number] : kLists) {
      const XmlElement* const cells = polydata_ ? piece.child(list) : nullptr;
      if (cells) read_cells(*cells, polydata_count(piece, number), vtk_polydata_type(list));
    }

    for_arrays(piece, "CellData", VtkGrid::is_region_array, [&](const std::string& name, const XmlElement& array) {
      grid_.add_cell_array(name, arrays_.values<double>(array, cell_count));
    });
    for_arrays(piece, "PointData", VtkGrid::is_group_array, [&](const std::string& name, const XmlElement& array) {
      grid_.add_point_array(name, arrays_.values<double>(array, point_count));
    });
    grid_.end_piece();
  }

  Scanner& in_;
  bool polydata_ = false;
  XmlElement root_;
  VtuArrays arrays_;
  MeshFile& file_;
  VtkGrid grid_;
};

}  // namespace

void read_vtu(Scanner& in, MeshFile& file) { VtuReader(in, file).read(); }

}  // namespace fascia
