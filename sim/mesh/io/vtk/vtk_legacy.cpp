// VTK legacy files (.vtk): keywords in text, arrays in text or in big-endian binary.
#include <algorithm>
#include <bit>
#include <map>

#include "sim/mesh/io/foreign_formats.h"
#include "sim/mesh/io/vtk/vtk.h"

namespace fascia {
namespace {

constexpr bool little_host = std::endian::native == std::endian::little;

std::string upper(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::toupper(c); });
  return out;
}

/// Array names contain %20 for a space and so on.
std::string decoded(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned byte = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(name.data() + i + 1, name.data() + i + 3, byte, 16).ptr == name.data() + i + 3) {
      out += static_cast<char>(byte);
      i += 2;
    } else {
      out += name[i];
    }
  }
  return out;
}

class LegacyReader {
 public:
  LegacyReader(Scanner& in, MeshFile& file) : in_(in), file_(file), grid_(file) {}
  void read();

 private:
  enum class Owner { field, points, cells };

  void read_header();
  void read_keyword(const std::string& keyword);
  void read_points();
  void read_cells();
  void read_polydata_cells(std::int64_t type);
  void read_cell_list();
  void read_cell_types();
  void read_attribute(const std::string& keyword);
  void read_field();
  void skip_strings(std::uint64_t count);
  void skip_metadata();
  void add_cells();

  VtkType type();
  /// Bytes (binary) or words (text) of an array; end_line() first.
  template <class T>
  std::vector<T> values(VtkType type, std::size_t count, const char* what);
  /// Fails if an array has more values than the file can hold, so their number does not overflow either.
  void check_array(const std::string& name, std::size_t components, std::size_t tuples,
                   std::size_t values_per_byte) const;
  /// One array of the current owner: kept if it contains regions or groups.
  void array(const std::string& name, VtkType type, std::size_t components, std::size_t tuples);

  Scanner& in_;
  MeshFile& file_;
  VtkGrid grid_;
  bool binary_ = false, polydata_ = false, has_points_ = false, has_cells_ = false, has_types_ = false;
  VtkCells cells_;
  std::size_t cell_count_ = 0;
  std::size_t cells_at_ = 0;  // offset of the list
  Owner owner_ = Owner::field;
  std::size_t owner_count_ = 0;
  bool bits_ = false;  // the last type() was "bit"
};

void LegacyReader::read_header() {
  std::string_view first = in_.line();
  first.remove_prefix(std::min(first.size(), std::string_view("# vtk DataFile Version ").size()));
  const std::string version(first.substr(0, first.find_first_of(" \t")));
  in_.line();  // title
  const std::string encoding = upper(in_.word("ASCII or BINARY"));
  if (encoding != "ASCII" && encoding != "BINARY")
    in_.fail("encoding is " + in_quotes(encoding), "expected ASCII or BINARY");
  binary_ = encoding == "BINARY";
  if (binary_) in_.locate_by_byte();
  in_.set_swapped(little_host);
  const std::string_view dataset = in_.word("DATASET");
  if (upper(dataset) != "DATASET")
    in_.fail(in_quotes(dataset) + " follows the encoding", "expected DATASET UNSTRUCTURED_GRID");
  const std::string kind = upper(in_.word("the kind of dataset"));
  polydata_ = kind == "POLYDATA";
  if (!polydata_ && kind != "UNSTRUCTURED_GRID")
    in_.fail("dataset is " + in_quotes(kind), "expected UNSTRUCTURED_GRID or POLYDATA" + way_of_vtk_dataset(kind));
  file_.format = "VTK legacy " + version + (binary_ ? " binary" : " ASCII");
}

void LegacyReader::read() {
  read_header();
  while (!in_.at_end()) read_keyword(upper(in_.word("a keyword")));
  in_.set_section("");
  if (!has_points_) in_.fail("has no points", "expected POINTS");
  if (polydata_ ? !has_cells_ : !has_cells_ || !has_types_)
    in_.fail("has no cells", polydata_ ? "expected POLYGONS" : "expected CELLS and CELL_TYPES");
  grid_.end_piece();
  if (!binary_) note_cut_off(in_, file_);
  grid_.finish(in_.where());
}

void LegacyReader::read_keyword(const std::string& keyword) {
  in_.set_section(keyword);
  if (keyword == "POINTS") return read_points();
  if (keyword == "CELLS" && !polydata_) return read_cells();
  if (keyword == "CELL_TYPES" && !polydata_) return read_cell_types();
  if (const auto cell = vtk_polydata_type(keyword); cell && polydata_) return read_polydata_cells(*cell);
  if (keyword == "METADATA") return skip_metadata();
  if (keyword == "FIELD") return read_field();
  if (keyword == "CELL_DATA" || keyword == "POINT_DATA") {
    const bool of_cells = keyword == "CELL_DATA";
    // The size of an array follows from its owner, which must be known by then.
    if (of_cells && !(has_cells_ && (has_types_ || polydata_)))
      in_.fail("stands before the cells",
               polydata_ ? "expected POLYGONS first" : "expected CELLS and CELL_TYPES first");
    if (!of_cells && !has_points_) in_.fail("stands before the points", "expected POINTS first");
    owner_ = of_cells ? Owner::cells : Owner::points;
    owner_count_ = of_cells ? cell_count_ : file_.mesh.positions.size();
    const auto count = in_.number<std::uint64_t>("a number of values");
    if (count != owner_count_) {
      in_.fail("is for " + std::to_string(count) + (of_cells ? " cells" : " points"),
               "expected " + std::to_string(owner_count_));
    }
    return;
  }
  read_attribute(keyword);
}

VtkType LegacyReader::type() {
  static const std::map<std::string_view, VtkType> types = {{"char", VtkType::int8},
                                                            {"unsigned_char", VtkType::uint8},
                                                            {"short", VtkType::int16},
                                                            {"unsigned_short", VtkType::uint16},
                                                            {"int", VtkType::int32},
                                                            {"unsigned_int", VtkType::uint32},
                                                            {"long", VtkType::int64},
                                                            {"unsigned_long", VtkType::uint64},
                                                            {"vtkidtype", VtkType::int32},
                                                            {"vtktypeint64", VtkType::int64},
                                                            {"vtktypeuint64", VtkType::uint64},
                                                            {"vtktypeint32", VtkType::int32},
                                                            {"vtktypeuint32", VtkType::uint32},
                                                            {"vtktypeint16", VtkType::int16},
                                                            {"vtktypeuint16", VtkType::uint16},
                                                            {"vtktypeint8", VtkType::int8},
                                                            {"vtktypeuint8", VtkType::uint8},
                                                            {"float", VtkType::float32},
                                                            {"double", VtkType::float64},
                                                            {"bit", VtkType::uint8}};
  const std::string_view word = in_.word("a data type");
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto found = types.find(lower);
  if (found == types.end())
    in_.fail("data type is " + in_quotes(word), "expected a number type such as float, double or int");
  bits_ = lower == "bit";
  return found->second;
}

template <class T>
std::vector<T> LegacyReader::values(VtkType type, std::size_t count, const char* what) {
  in_.check_count(count, what, binary_ ? size_of(type) : 2);
  if (binary_) return vtk_values<T>(in_.bytes(count * size_of(type), what), type, little_host);
  std::vector<T> out(count);
  const bool real = type == VtkType::float32 || type == VtkType::float64;
  for (T& value : out) {
    if constexpr (std::is_same_v<T, double>) {
      value = in_.number<double>(what);
    } else {
      if (real) in_.fail(std::string("type of ") + what + " is a floating-point type", "expected whole numbers");
      value = in_.number<std::int64_t>(what);
    }
  }
  return out;
}

void LegacyReader::read_points() {
  if (has_points_) in_.fail("is the second list of points", "expected one");
  has_points_ = true;
  const std::size_t count = in_.count("points", binary_ ? 3 : 6);
  const VtkType scalar = type();
  in_.end_line("the data type");
  in_.check_count(count, "points", binary_ ? 3 * size_of(scalar) : 6);
  if (binary_) {
    grid_.add_points(in_, values<double>(scalar, 3 * count, "coordinates"));
  } else {
    std::vector<double> coordinates(3 * count);
    for (double& x : coordinates) x = in_.coordinate("a point coordinate");
    grid_.add_points(in_, coordinates);
  }
}

void LegacyReader::read_cells() {
  if (has_cells_) in_.fail("is the second list of cells", "expected one");
  has_cells_ = true;
  read_cell_list();
  add_cells();
}

/// Polydata has a list for each kind of cell instead of types.
void LegacyReader::read_polydata_cells(std::int64_t type) {
  has_cells_ = true;
  if (!has_points_) in_.fail("stands before the points", "expected POINTS first");
  cells_ = {};
  read_cell_list();
  cells_.types.assign(cells_.offsets.size(), type);
  in_.blame(cells_at_);
  grid_.add_cells(in_, cells_);
  cell_count_ += cells_.types.size();
}

void LegacyReader::read_cell_list() {
  cells_at_ = in_.offset();
  const std::size_t first = in_.count("cells", binary_ ? 4 : 2);
  const std::size_t second = in_.count("numbers", binary_ ? 4 : 2);
  in_.end_line("the size of the list");
  if (in_.take("OFFSETS")) {  // 5.x: `first` offsets, one more than cells
    const VtkType offset_type = type();
    in_.end_line("the data type");
    cells_.offsets = values<std::int64_t>(offset_type, first, "offsets");
    if (!cells_.offsets.empty()) {
      if (cells_.offsets[0] != 0) in_.fail("first offset is " + std::to_string(cells_.offsets[0]), "expected 0");
      cells_.offsets.erase(cells_.offsets.begin());
    }
    const std::string_view word = in_.word("CONNECTIVITY");
    if (word != "CONNECTIVITY") in_.fail(in_quotes(word) + " follows the offsets", "expected CONNECTIVITY");
    const VtkType connectivity_type = type();
    in_.end_line("the data type");
    cells_.connectivity = values<std::int64_t>(connectivity_type, second, "point numbers");
  } else {
    cells_.offsets.reserve(first);
    cells_.connectivity.reserve(second > first ? second - first : 0);
    std::size_t used = 0;
    for (std::size_t c = 0; c < first; ++c) {
      const std::int64_t nodes =
          binary_ ? in_.binary<std::int32_t>("the size of a cell") : in_.number<std::int64_t>("the size of a cell");
      if (nodes < 0 || used >= second || static_cast<std::uint64_t>(nodes) > second - used - 1) {
        in_.fail("cell " + std::to_string(c) + " has " + std::to_string(nodes) + " points",
                 "expected at most the " + std::to_string(second - used) + " numbers left of the list");
      }
      used += static_cast<std::size_t>(nodes) + 1;
      for (std::int64_t i = 0; i < nodes; ++i) {
        cells_.connectivity.push_back(binary_ ? in_.binary<std::int32_t>("a point number")
                                              : in_.number<std::int64_t>("a point number"));
      }
      cells_.offsets.push_back(static_cast<std::int64_t>(cells_.connectivity.size()));
    }
    if (used != second)
      in_.fail("cells take " + std::to_string(used) + " numbers", "expected " + std::to_string(second));
  }
}

void LegacyReader::read_cell_types() {
  if (has_types_) in_.fail("is the second list of cell types", "expected one");
  has_types_ = true;
  const std::size_t count = in_.count("cell types", binary_ ? 4 : 2);
  in_.end_line("the number of cell types");
  cells_.types = values<std::int64_t>(VtkType::int32, count, "cell types");
  add_cells();
}

void LegacyReader::add_cells() {
  if (!has_cells_ || !has_types_) return;
  if (!has_points_) in_.fail("stands before the points", "expected POINTS first");
  if (cells_.types.size() != cells_.offsets.size()) {
    in_.fail(
        std::to_string(cells_.types.size()) + " cell types for " + std::to_string(cells_.offsets.size()) + " cells",
        "expected one for each");
  }
  in_.set_section("CELLS");
  in_.blame(cells_at_);
  grid_.add_cells(in_, cells_);
  cell_count_ = cells_.types.size();
  cells_.connectivity = {};
}

void LegacyReader::check_array(const std::string& name, std::size_t components, std::size_t tuples,
                               std::size_t values_per_byte) const {
  if (components != 0 && tuples > values_per_byte * in_.data().size() / components) {
    in_.fail("array " + in_quotes(name) + " of " + std::to_string(tuples) + " times " + std::to_string(components) +
                 " values",
             "expected no more than the file holds");
  }
}

void LegacyReader::array(const std::string& name, VtkType type, std::size_t components, std::size_t tuples) {
  check_array(name, components, tuples, bits_ ? 8 : 1);
  const std::size_t count = components * tuples;
  if (bits_ && binary_) {
    in_.skip((count + 7) / 8, "an array of bits");
    return;
  }
  std::vector<double> read = values<double>(type, count, "values of an array");
  if (owner_ == Owner::field) {
    if (VtkGrid::is_region_name(name)) grid_.add_field_array(name, read);
  } else if (components == 1 && tuples == owner_count_) {
    if (owner_ == Owner::cells && VtkGrid::is_region_array(name)) grid_.add_cell_array(name, std::move(read));
    if (owner_ == Owner::points && VtkGrid::is_group_array(name)) grid_.add_point_array(name, read);
  }
}

void LegacyReader::read_field() {
  in_.word("the name of the field");
  const std::size_t arrays = in_.count("arrays", 6);
  for (std::size_t i = 0; i < arrays; ++i) {
    if (in_.take("METADATA")) skip_metadata();
    const std::string name = decoded(in_.word("the name of an array"));
    const auto components = in_.number<std::uint32_t>("the number of components");
    const auto tuples = in_.number<std::uint64_t>("the number of tuples");
    if (in_.take("string")) {
      check_array(name, components, tuples, 1);
      skip_strings(components * tuples);
      continue;
    }
    const VtkType scalar = type();
    in_.end_line("the data type");
    array(name, scalar, components, tuples);
  }
}

void LegacyReader::skip_strings(std::uint64_t count) {
  in_.end_line("the data type");
  in_.check_count(count, "strings", 1);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!binary_) {
      in_.line();
      continue;
    }
    // The two highest bits of the first byte give the number of bytes of the length: 8, 4, 2 or 1.
    const auto first = static_cast<unsigned char>(in_.bytes(1, "the length of a string")[0]);
    std::uint64_t length = first & 63;
    for (int rest = (8 >> (first >> 6)) - 1; rest > 0; --rest) {
      length = length << 8 | static_cast<unsigned char>(in_.bytes(1, "the length of a string")[0]);
    }
    in_.skip(length, "a string");
  }
}

/// Skips information lines up to an empty one.
void LegacyReader::skip_metadata() {
  in_.line();
  while (in_.remaining() > 0 && in_.line().find_first_not_of(" \t") != std::string_view::npos) {
  }
}

void LegacyReader::read_attribute(const std::string& keyword) {
  static const std::map<std::string_view, std::size_t> components = {
      {"SCALARS", 1},       {"VECTORS", 3},      {"NORMALS", 3},
      {"TENSORS", 9},       {"TENSORS6", 6},     {"TEXTURE_COORDINATES", 2},
      {"GLOBAL_IDS", 1},    {"PEDIGREE_IDS", 1}, {"EDGE_FLAGS", 1},
      {"COLOR_SCALARS", 4}, {"LOOKUP_TABLE", 4}};
  const auto found = components.find(keyword);
  if (found == components.end() || owner_ == Owner::field) {
    in_.set_section("");
    in_.fail("keyword is " + in_quotes(keyword),
             polydata_
                 ? "expected POINTS, POLYGONS, TRIANGLE_STRIPS, LINES, VERTICES, CELL_DATA, POINT_DATA or an attribute"
                 : "expected POINTS, CELLS, CELL_TYPES, CELL_DATA, POINT_DATA or an attribute");
  }
  const std::string name = decoded(in_.word("the name of an array"));
  std::size_t width = found->second, tuples = owner_count_;
  VtkType scalar = VtkType::uint8;
  bits_ = false;
  if (keyword == "LOOKUP_TABLE" || keyword == "COLOR_SCALARS") {  // bytes in binary, numbers from 0 to 1 in text
    const auto size =
        in_.number<std::uint32_t>(keyword == "LOOKUP_TABLE" ? "the size of the table" : "the number of components");
    (keyword == "LOOKUP_TABLE" ? tuples : width) = size;
  } else {
    if (keyword == "TEXTURE_COORDINATES") width = in_.number<std::uint32_t>("the number of components");
    scalar = type();
    if (keyword == "SCALARS" && !in_.at_line_end()) width = in_.number<std::uint32_t>("the number of components");
  }
  in_.end_line("the line of the array");
  if (keyword == "SCALARS") {
    const std::string_view table = in_.word("LOOKUP_TABLE");
    if (upper(table) != "LOOKUP_TABLE") in_.fail(in_quotes(table) + " follows SCALARS", "expected LOOKUP_TABLE");
    in_.word("the name of the table");
    in_.end_line("the name of the table");
  }
  array(name, scalar, width, tuples);
}

}  // namespace

void read_vtk_legacy(Scanner& in, MeshFile& file) { LegacyReader(in, file).read(); }

}  // namespace fascia
