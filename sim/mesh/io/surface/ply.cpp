// PLY (Turk 1994): a header in text that lists elements and their properties, then the elements in text or in binary of
// either byte order. Positions and colors of vertices and the corners of faces and of strips of triangles are kept.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

#include "base/number_text.h"
#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct Element {
  std::string name;
  std::size_t at;  // offset of its line in the header
  std::uint64_t count;
  std::vector<Property> properties;

  std::size_t find(std::string_view property) const {
    const auto found =
        std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == property; });
    return static_cast<std::size_t>(found - properties.begin());
  }
};

class PlyReader {
 public:
  PlyReader(Scanner& in, MeshFile& file) : in_(in), file_(file) {}

  void read() {
    read_header();
    for (const Element& element : elements_) read_element(element);
    if (binary_) {
      in_.blame(in_.offset());
      if (in_.remaining() > 0) in_.fail("something follows the last element", "expected the end of the file");
    } else {
      if (!in_.at_end()) in_.fail("something follows the last element", "expected the end of the file");
      note_cut_off(in_, file_);
    }
    finish_mesh(file_, in_.where());
  }

 private:
  void read_header() {
    in_.line();  // ply
    for (;;) {
      const std::string_view keyword = in_.word("end_header");
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format();
      } else if (keyword == "element") {
        read_element_line();
      } else if (keyword == "property") {
        read_property_line();
      } else if (keyword == "comment" || keyword == "obj_info") {
        in_.line();
        continue;
      } else {
        in_.fail("found " + in_quotes(keyword), "expected format, element, property, comment or end_header");
      }
      in_.end_line("the line of the header");
    }
    if (file_.format.empty())
      in_.fail("the header has no format", "expected ascii, binary_little_endian or binary_big_endian");
    in_.end_line("end_header");
    if (binary_) in_.locate_by_byte();
  }

  void read_format() {
    const std::string format(in_.word("the format"));
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      in_.fail("format is " + in_quotes(format), "expected ascii, binary_little_endian or binary_big_endian");
    in_.word("the version");
    binary_ = format != "ascii";
    in_.set_swapped((format == "binary_big_endian") == (std::endian::native == std::endian::little));
    file_.format = !binary_ ? "PLY ASCII" : format == "binary_big_endian" ? "PLY binary, big-endian" : "PLY binary";
  }

  void read_element_line() {
    const std::string name(in_.word("the name of an element"));
    const std::size_t at = in_.offset();
    const auto count = in_.number_on_line<std::uint64_t>("the number of elements");
    if (std::any_of(elements_.begin(), elements_.end(), [&](const Element& e) { return e.name == name; }))
      in_.fail("is the second element " + in_quotes(name), "expected one");
    elements_.push_back({name, at, count, {}});
  }

  PlyType type() {
    static const std::map<std::string_view, PlyType> types = {
        {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
        {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
        {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
        {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
        {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
        {"float64", PlyType::float64}};
    const std::string_view word = in_.word("a type");
    const auto found = types.find(word);
    if (found == types.end()) in_.fail("type is " + in_quotes(word), "expected a type such as float, uchar or int");
    return found->second;
  }

  void read_property_line() {
    if (elements_.empty()) in_.fail("a property stands before the first element", "expected an element");
    Property property{};
    property.is_list = in_.take("list");
    if (property.is_list) {
      property.count_type = type();
      if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64)
        in_.fail("the length of a list is a floating-point number", "expected a whole number");
    }
    property.type = type();
    property.name = in_.word("the name of a property");
    elements_.back().properties.push_back(property);
  }

  double value(PlyType type, const char* what) {
    const bool real = type == PlyType::float32 || type == PlyType::float64;
    if (!binary_)
      return real ? in_.number_on_line<double>(what) : static_cast<double>(in_.number_on_line<std::int64_t>(what));
    switch (type) {
      case PlyType::int8:
        return in_.binary<std::int8_t>(what);
      case PlyType::uint8:
        return in_.binary<std::uint8_t>(what);
      case PlyType::int16:
        return in_.binary<std::int16_t>(what);
      case PlyType::uint16:
        return in_.binary<std::uint16_t>(what);
      case PlyType::int32:
        return in_.binary<std::int32_t>(what);
      case PlyType::uint32:
        return in_.binary<std::uint32_t>(what);
      case PlyType::float32:
        return static_cast<double>(in_.binary<float>(what));
      case PlyType::float64:
        return in_.binary<double>(what);
    }
    return 0;
  }

  /// Reads all properties of one entry: scalars into values_, the list number `wanted` into list_.
  void read_entry(const Element& element, std::size_t wanted) {
    if (!binary_) in_.at_end();  // to the next line that is not empty
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      if (!property.is_list) {
        values_[p] = value(property.type, "a property");
        continue;
      }
      const double length = value(property.count_type, "the length of a list");
      if (length < 0)
        in_.fail("the length of a list is " + std::to_string(static_cast<std::int64_t>(length)), "expected 0 or more");
      const auto count = static_cast<std::uint64_t>(length);
      in_.check_count(count, "values of a list", binary_ ? size_of(property.type) : 2);
      if (p == wanted) list_.clear();
      for (std::uint64_t i = 0; i < count; ++i) {
        const double entry = value(property.type, "a value of a list");
        if (p == wanted) list_.push_back(entry);
      }
    }
    if (!binary_) in_.end_line("the properties of an element");
  }

  void read_element(const Element& element) {
    in_.set_section("element " + element.name);
    if (!element.properties.empty()) {
      std::size_t bytes = 0;
      for (const Property& p : element.properties) bytes += binary_ ? size_of(p.is_list ? p.count_type : p.type) : 2;
      in_.check_count(element.count, "elements", bytes);
      values_.assign(element.properties.size(), 0);
    }
    if (element.name == "vertex") {
      read_vertices(element);
    } else if (element.name == "face" || element.name == "tristrips") {
      read_faces(element);
    } else if (!element.properties.empty()) {
      for (std::uint64_t i = 0; i < element.count; ++i) read_entry(element, element.properties.size());
    }
    in_.set_section("");
  }

  std::size_t scalar(const Element& element, const char* name) {
    const std::size_t property = element.find(name);
    if (property == element.properties.size() || element.properties[property].is_list) {
      in_.blame(element.at);
      in_.fail("element " + element.name + " has no property " + name, "expected x, y and z of a vertex");
    }
    return property;
  }

  void read_vertices(const Element& element) {
    has_vertices_ = true;
    const std::array<std::size_t, 3> xyz = {scalar(element, "x"), scalar(element, "y"), scalar(element, "z")};
    const std::size_t none = element.properties.size();
    const std::array<std::size_t, 3> rgb = {element.find("red"), element.find("green"), element.find("blue")};
    const bool colored =
        std::all_of(rgb.begin(), rgb.end(), [&](std::size_t p) { return p < none && !element.properties[p].is_list; });
    check_vertex_count(in_, element.count);
    file_.mesh.positions.reserve(element.count);
    for (std::uint64_t v = 0; v < element.count; ++v) {
      read_entry(element, none);
      Eigen::Vector3d x;
      for (std::size_t k = 0; k < 3; ++k) {
        x[static_cast<Eigen::Index>(k)] = values_[xyz[k]];
        if (!std::isfinite(values_[xyz[k]])) {
          in_.fail(std::string("coordinate ") + "xyz"[k] + " of vertex " + std::to_string(v) + " is " +
                       (std::isnan(values_[xyz[k]]) ? "nan" : "infinite"),
                   "expected a finite number");
        }
      }
      file_.mesh.positions.push_back(x);
      if (colored) file_.vertex_colors.push_back(color(element, rgb));
    }
  }

  std::uint32_t color(const Element& element, const std::array<std::size_t, 3>& rgb) const {
    std::uint32_t packed = 0xff000000u;
    for (std::size_t k = 0; k < 3; ++k) {
      const PlyType type = element.properties[rgb[k]].type;
      const double full = type == PlyType::float32 || type == PlyType::float64 ? 255
                          : type == PlyType::uint16                            ? 255.0 / 65535
                                                                               : 1;
      const double share = full * values_[rgb[k]];
      packed |= static_cast<std::uint32_t>(std::lround(share > 0 ? std::min(share, 255.0) : 0)) << (8 * k);
    }
    return packed;
  }

  void read_faces(const Element& element) {
    if (!has_vertices_) in_.fail("faces stand before the vertices", "expected element vertex first");
    std::size_t list = element.find("vertex_indices");
    const std::size_t none = element.properties.size();
    if (list == none) list = element.find("vertex_index");
    if (list == none || !element.properties[list].is_list) {
      in_.blame(element.at);
      in_.fail("element " + element.name + " has no list vertex_indices", "expected one");
    }
    const bool strips = element.name == "tristrips";
    const auto vertex_count = static_cast<double>(file_.mesh.positions.size());
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < element.count; ++f) {
      read_entry(element, list);
      corners.clear();
      for (const double vertex : list_) {
        if (strips && vertex == -1) {  // the next strip begins
          add_strip(corners);
          corners.clear();
          continue;
        }
        if (!(vertex >= 0 && vertex < vertex_count && vertex == std::floor(vertex))) {
          in_.fail("face " + std::to_string(f) + " names vertex " + NumberText().add(vertex).take(),
                   "expected 0 to " + std::to_string(static_cast<std::int64_t>(vertex_count) - 1));
        }
        corners.push_back(static_cast<std::uint32_t>(vertex));
      }
      strips ? add_strip(corners) : add_face(file_, corners);
    }
  }

  /// Every three neighbors are a triangle; every second one is wound against the others.
  void add_strip(std::span<const std::uint32_t> strip) {
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      const std::array triangle = {strip[i + i % 2], strip[i + 1 - i % 2], strip[i + 2]};
      const bool degenerate = triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
      if (!degenerate) add_face(file_, triangle);  // those that join two strips
    }
  }

  Scanner& in_;
  MeshFile& file_;
  bool binary_ = false, has_vertices_ = false;
  std::vector<Element> elements_;
  std::vector<double> values_, list_;  // of the entry that was read last
};

}  // namespace

void read_ply(Scanner& in, MeshFile& file) { PlyReader(in, file).read(); }

}  // namespace fascia
