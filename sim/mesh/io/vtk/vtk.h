// The common part of VTK's legacy and XML formats: scalar types, cells by offsets, and the arrays that hold regions and
// groups. fascia keeps a vertex group as a point array "group:NAME" (1 inside) and a region's name as a field array
// "region_name:NAME" that holds its number, so that both are preserved in files that ParaView reads.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"

namespace fascia {

enum class VtkType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
std::size_t size_of(VtkType type);

inline constexpr std::string_view vtk_group_prefix = "group:";
inline constexpr std::string_view vtk_region_name_prefix = "region_name:";

/// Values of `bytes` (a whole number of them), in the file's byte order. Floats that do not fit int64 become its
/// minimum.
template <class T>
std::vector<T> vtk_values(std::string_view bytes, VtkType type, bool swapped);
extern template std::vector<double> vtk_values<double>(std::string_view, VtkType, bool);
extern template std::vector<std::int64_t> vtk_values<std::int64_t>(std::string_view, VtkType, bool);

/// The cell type of a list of polydata, POLYGONS in legacy files and Polys in XML; none if the word is no such list.
std::optional<std::int64_t> vtk_polydata_type(std::string_view list);

/// Cells of one piece. offsets[i] is the end of cell i in connectivity.
struct VtkCells {
  std::vector<std::int64_t> connectivity, offsets, types;
};

/// Collects the parts of an unstructured grid or of polygons, piece by piece.
class VtkGrid {
 public:
  explicit VtkGrid(MeshFile& file) : file_(file) {}

  void add_points(const Scanner& in, const std::vector<double>& coordinates);
  /// Cells name the points of the piece that was added last. Errors have the scanner's location.
  void add_cells(const Scanner& in, const VtkCells& cells);
  /// Cell, point and field arrays with one component; unknown ones are skipped.
  void add_cell_array(const std::string& name, std::vector<double> values);
  void add_point_array(const std::string& name, const std::vector<double>& values);
  void add_field_array(const std::string& name, const std::vector<double>& values);
  /// To be called after the cells and arrays of each piece.
  void end_piece();
  void finish(const std::string& where);

  static bool is_region_array(std::string_view name);
  static bool is_group_array(std::string_view name) { return name.starts_with(vtk_group_prefix); }
  static bool is_region_name(std::string_view name) { return name.starts_with(vtk_region_name_prefix); }

 private:
  /// Into corners_, around the cell.
  const std::vector<std::uint32_t>& vertices(std::int64_t type, std::span<const std::int64_t> points);
  void add_polygon(std::int64_t type, std::span<const std::int64_t> points);

  MeshFile& file_;
  std::vector<std::uint32_t> corners_;           // of one cell
  std::size_t first_point_ = 0, first_tet_ = 0;  // of the piece
  std::vector<std::size_t> tet_cells_;           // [tets of the piece] index of the cell
  bool second_order_ = false;
  std::optional<std::pair<std::string, std::vector<double>>> region_array_;  // the best candidate of the piece so far
};

}  // namespace fascia
