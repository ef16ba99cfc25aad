#include "sim/mesh/io/vtk/vtk.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

namespace fascia {
namespace {

struct CellType {
  int dimension, corners;  // corners 0: any number
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
      return {1, 0};  // curves of higher order
    case 5:
      return {2, 3};  // triangle
    case 22:
    case 34:
    case 69:
      return {2, 3};  // triangles of higher order
    case 10:
      return {3, 4};  // tet
    case 24:
    case 71:
      return {3, 4};  // tets of higher order
    default:
      return {3, 0};
  }
}

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
    const bool exact = cells.types[c] == 1 || cells.types[c] == 3 || cells.types[c] == 5 || cells.types[c] == 10;
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
    if (type.dimension != 3 || type.corners != 4) {
      count_ignored(file_, type.dimension, type.corners);
      continue;
    }
    second_order_ |= nodes > 4;
    Tet tet;
    for (std::size_t i = 0; i < 4; ++i)
      tet[i] = static_cast<std::uint32_t>(static_cast<std::int64_t>(first_point_) + points[i]);
    file_.mesh.tets.push_back(tet);
    tet_cells_.push_back(c);
  }
  if (begin != ends) {
    in.fail("cells end at offset " + std::to_string(begin),
            "expected " + std::to_string(ends) + ", the size of the connectivity");
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
  if (region_array_) {
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
  if (second_order_) file_.notes.push_back("Tets of higher order: kept the four corners of each.");
  finish_mesh(file_, where);
}

}  // namespace fascia
