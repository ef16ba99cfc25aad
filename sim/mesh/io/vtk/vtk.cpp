#include "sim/mesh/io/vtk/vtk.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

namespace fascia {
namespace {

struct CellType {
  int dimension, corners;  // corners 0: any number; of three dimensions: a kind without tets
};

CellType cell_type(std::int64_t type) {
  switch (type) {
    case 1:
      return {0, 1};  // vertex
    case 2:
      return {0, 0};  // poly vertex
    case 3:
      return {1, 2};  // line
    case 4:
      return {1, 0};  // poly line
    case 21:
    case 35:
    case 68:
    case 75:
      return {1, 0};  // curves of higher order
    case 5:
      return {2, 3};  // triangle
    case 22:
    case 34:
    case 69:
    case 76:
      return {2, 3};  // triangles of higher order
    case 10:
      return {3, 4};  // tet
    case 24:
    case 71:
    case 78:
      return {3, 4};  // tets of higher order
    case 6:
    case 7:
      return {2, 0};  // triangle strip, polygon
    case 8:
    case 9:
    case 23:
    case 28:
    case 30:
    case 36:
    case 70:
    case 77:
      return {2, 4};  // pixel, quads
    case 11:
    case 12:
    case 25:
    case 29:
    case 33:
    case 72:
    case 79:
      return {3, 8};  // voxel, hexahedra
    case 13:
    case 26:
    case 31:
    case 32:
    case 73:
    case 80:
      return {3, 6};  // wedges
    case 14:
    case 27:
    case 37:
    case 74:
    case 81:
      return {3, 5};  // pyramids
    default:
      return {3, 0};
  }
}

/// Linear cells have exactly their corners.
bool is_linear(std::int64_t type) {
  constexpr std::array<std::int64_t, 10> types = {1, 3, 5, 8, 9, 10, 11, 12, 13, 14};
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// The corners of voxels and pixels go along the axes, not around.
constexpr std::int64_t kPixel = 8, kVoxel = 11, kStrip = 6;
/// With ten points they have the same order.
constexpr std::int64_t kQuadraticTet = 24, kLagrangeTet = 71;

/// Best first. Compared case-insensitively.
constexpr std::array<std::string_view, 14> region_names = {
    "region",   "regions",   "region_id",   "gmsh:physical", "cellentityids", "medit:ref", "tetgen:ref",
    "material", "materials", "material_id", "materialid",    "materialids",   "subdomain", "attribute"};

std::size_t region_rank(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return static_cast<std::size_t>(std::find(region_names.begin(), region_names.end(), lower) - region_names.begin());
}

template <class To, class From>
To convert(From value) {
  if constexpr (std::is_integral_v<To> && std::is_floating_point_v<From>) {
    if (!(value > -9.2e18 && value < 9.2e18)) return std::numeric_limits<To>::min();
  }
  return static_cast<To>(value);
}

template <class To, class From>
std::vector<To> values_of(std::string_view bytes, bool swapped) {
  std::vector<To> out(bytes.size() / sizeof(From));
  for (std::size_t i = 0; i < out.size(); ++i) {
    From value;
    std::memcpy(&value, bytes.data() + i * sizeof(From), sizeof(From));
    out[i] = convert<To>(swapped ? byte_swapped(value) : value);
  }
  return out;
}

}  // namespace

std::optional<std::int64_t> vtk_polydata_type(std::string_view list) {
  if (list == "VERTICES" || list == "Verts") return 2;
  if (list == "LINES" || list == "Lines") return 4;
  if (list == "TRIANGLE_STRIPS" || list == "Strips") return kStrip;
  if (list == "POLYGONS" || list == "Polys") return 7;
  return std::nullopt;
}

std::size_t size_of(VtkType type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

template <class T>
std::vector<T> vtk_values(std::string_view bytes, VtkType type, bool swapped) {
  switch (type) {
    case VtkType::int8:
      return values_of<T, std::int8_t>(bytes, swapped);
    case VtkType::uint8:
      return values_of<T, std::uint8_t>(bytes, swapped);
    case VtkType::int16:
      return values_of<T, std::int16_t>(bytes, swapped);
    case VtkType::uint16:
      return values_of<T, std::uint16_t>(bytes, swapped);
    case VtkType::int32:
      return values_of<T, std::int32_t>(bytes, swapped);
    case VtkType::uint32:
      return values_of<T, std::uint32_t>(bytes, swapped);
    case VtkType::int64:
      return values_of<T, std::int64_t>(bytes, swapped);
    case VtkType::uint64:
      return values_of<T, std::uint64_t>(bytes, swapped);
    case VtkType::float32:
      return values_of<T, float>(bytes, swapped);
    case VtkType::float64:
      return values_of<T, double>(bytes, swapped);
  }
  return {};
}
template std::vector<double> vtk_values<double>(std::string_view, VtkType, bool);
template std::vector<std::int64_t> vtk_values<std::int64_t>(std::string_view, VtkType, bool);

bool VtkGrid::is_region_array(std::string_view name) { return region_rank(name) < region_names.size(); }

void VtkGrid::add_points(const Scanner& in, const std::vector<double>& coordinates) {
  auto& positions = file_.mesh.positions;
  first_point_ = positions.size();
  check_vertex_count(in, first_point_ + coordinates.size() / 3);
  positions.reserve(first_point_ + coordinates.size() / 3);
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(coordinates[i + k])) {
        in.fail(std::string("coordinate ") + "xyz"[k] + " of point " + std::to_string(i / 3) + " is " +
                    (std::isnan(coordinates[i + k]) ? "nan" : "infinite"),
                "expected a finite number");
      }
    }
    positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
}

void VtkGrid::add_cells(const Scanner& in, const VtkCells& cells) {
  const auto point_count = static_cast<std::int64_t>(file_.mesh.positions.size() - first_point_);
  const auto ends = static_cast<std::int64_t>(cells.connectivity.size());
  std::int64_t begin = 0;
  first_tet_ = file_.mesh.tets.size();
  tet_cells_.clear();
  for (std::size_t c = 0; c < cells.types.size(); ++c) {
    const auto fail = [&](const std::string& what, const std::string& expected) {
      in.fail("cell " + std::to_string(c) + " " + what, expected);
    };
    const std::int64_t end = cells.offsets[c];
    if (end < begin || end > ends) {
      fail("ends at offset " + std::to_string(end),
           "expected " + std::to_string(begin) + " to " + std::to_string(ends));
    }
    const CellType type = cell_type(cells.types[c]);
    const std::int64_t nodes = end - begin;
    const bool exact = is_linear(cells.types[c]);
    if (exact ? nodes != type.corners : nodes < type.corners) {
      fail("of type " + std::to_string(cells.types[c]) + " has " + std::to_string(nodes) + " points",
           "expected " + std::string(exact ? "" : "at least ") + std::to_string(type.corners));
    }
    const std::int64_t* const points = cells.connectivity.data() + begin;
    begin = end;
    if (cells.types[c] != 42) {  // a polyhedron in a legacy file lists counts among its points
      for (std::int64_t i = 0; i < nodes; ++i) {
        if (points[i] < 0 || points[i] >= point_count) {
          fail("names point " + std::to_string(points[i]), "expected 0 to " + std::to_string(point_count - 1));
        }
      }
    }
    second_order_ |= type.dimension >= 2 && type.corners > 0 && nodes > type.corners;
    if (type.dimension == 2) {
      add_polygon(cells.types[c], {points, static_cast<std::size_t>(type.corners == 0 ? nodes : type.corners)});
    } else if (type.dimension == 3 && type.corners > 0) {
      const std::size_t tets =
          add_solid(file_, vertices(cells.types[c], {points, static_cast<std::size_t>(type.corners)}));
      tet_cells_.insert(tet_cells_.end(), tets, c);
      if ((cells.types[c] == kQuadraticTet || cells.types[c] == kLagrangeTet) && nodes == 10) {
        const std::vector<std::uint32_t>& v = vertices(cells.types[c], {points + 4, 6});
        set_mid_edges(file_, {v[0], v[1], v[2], v[3], v[4], v[5]});
      }
    } else {
      count_ignored(file_, type.dimension, type.corners);
    }
  }
  if (begin != ends) {
    in.fail("cells end at offset " + std::to_string(begin),
            "expected " + std::to_string(ends) + ", the size of the connectivity");
  }
}

const std::vector<std::uint32_t>& VtkGrid::vertices(std::int64_t type, std::span<const std::int64_t> points) {
  corners_.clear();
  for (const std::int64_t point : points)
    corners_.push_back(static_cast<std::uint32_t>(static_cast<std::int64_t>(first_point_) + point));
  if (type == kPixel || type == kVoxel) std::swap(corners_[2], corners_[3]);
  if (type == kVoxel) std::swap(corners_[6], corners_[7]);
  return corners_;
}

void VtkGrid::add_polygon(std::int64_t type, std::span<const std::int64_t> points) {
  if (type != kStrip) return add_face(file_, vertices(type, points));
  const std::vector<std::uint32_t>& strip = vertices(type, points);
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {  // every second triangle is wound against its corners' order
    const std::array<std::uint32_t, 3> triangle = {strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]};
    add_face(file_, triangle);
  }
}

void VtkGrid::add_cell_array(const std::string& name, std::vector<double> values) {
  if (!region_array_ || region_rank(name) < region_rank(region_array_->first)) {
    region_array_.emplace(name, std::move(values));
  }
}

void VtkGrid::add_point_array(const std::string& name, const std::vector<double>& values) {
  std::vector<std::uint32_t>& group = file_.mesh.groups[name.substr(vtk_group_prefix.size())];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != 0) group.push_back(static_cast<std::uint32_t>(first_point_ + i));
  }
}

void VtkGrid::add_field_array(const std::string& name, const std::vector<double>& values) {
  if (values.size() != 1 || !is_region(values[0])) return;
  file_.mesh.region_names[static_cast<int>(values[0])] = name.substr(vtk_region_name_prefix.size());
}

void VtkGrid::end_piece() {
  std::vector<int>& regions = file_.mesh.regions;
  regions.resize(file_.mesh.tets.size(), 0);
  if (region_array_ && !tet_cells_.empty()) {
    const auto& [name, values] = *region_array_;
    const bool whole =
        std::all_of(tet_cells_.begin(), tet_cells_.end(), [&v = values](std::size_t c) { return is_region(v[c]); });
    if (whole) {
      for (std::size_t i = 0; i < tet_cells_.size(); ++i)
        regions[first_tet_ + i] = static_cast<int>(values[tet_cells_[i]]);
    }
    const std::string note = whole ? "Regions are those of the cell array '" + name + "'."
                                   : "Cell array '" + name + "' holds no whole numbers: no regions.";
    if (std::find(file_.notes.begin(), file_.notes.end(), note) == file_.notes.end()) file_.notes.push_back(note);
  }
  region_array_.reset();
}

void VtkGrid::finish(const std::string& where) {
  if (second_order_) file_.notes.push_back(kHigherOrderNote);
  finish_mesh(file_, where);
}

}  // namespace fascia
