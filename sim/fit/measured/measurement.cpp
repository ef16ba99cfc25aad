#include "sim/fit/measured/measurement.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "base/suggest.h"
#include "base/text.h"
#include "sim/contact/pair_energy.h"
#include "sim/fit/measured/drive.h"
#include "sim/fit/measured/measured_table.h"
#include "sim/fit/measured/shape_distance.h"
#include "sim/model/vertex_csv.h"
#include "sim/reference/newton.h"
#include "sim/surface/shape_file.h"

namespace fascia {
namespace {

using Kind = Measurand::Kind;

constexpr const char* kNames =
    "expected time_s, displacement_mm, or a force or place with its unit: reaction_y_N, grab_y_mN, support_0_y_N, "
    "contact_NAME_y_N, probe_y_mm, vertex_12_y_mm";

std::optional<std::size_t> index_of(std::string_view text) {
  std::size_t index = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (text.empty() || problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

std::size_t index_below(std::string_view text, std::size_t count, const std::string& what, const std::string& where) {
  const std::optional<std::size_t> index = index_of(text);
  if (!index || *index >= count)
    throw Error(where, what + " " + std::string(text) + " does not exist",
                count == 0 ? "expected none in this scene" : "expected 0 to " + std::to_string(count - 1));
  return *index;
}

// The name of a tool in a column, which has no commas.
std::string in_column(std::string name) {
  std::replace(name.begin(), name.end(), ',', '_');
  return name;
}

class CurveReader {
 public:
  CurveReader(const std::filesystem::path& file, const Model& model, const MeasurementRead& how)
      : model_(model), how_(how), table_(read_measured_table(file, read_file(file))), probe_(how.probe) {
    where_ = file.string() + ":" + std::to_string(table_.header_line);
    for (const auto& [a, b] : touching_bodies(model))
      between_.push_back("contact_" + in_column(model.bodies[a].name) + "_" + in_column(model.bodies[b].name) + "_");
    for (const auto& [keyword, text] : table_.notes)
      if (keyword == "Probe" && text.starts_with("vertex "))
        probe_ = static_cast<std::uint32_t>(
            index_below(std::string_view(text).substr(7), model.rest_positions.size(), "vertex", file.string()));
  }

  void read(Measurement& measurement) {
    std::vector<std::string> left_out;
    for (std::size_t c = 0; c < table_.names.size(); ++c) {
      const std::string& name = table_.names[c];
      if (std::find(how_.passed_over.begin(), how_.passed_over.end(), name) != how_.passed_over.end() &&
          !is_vector(name) && !is_time(name))
        left_out.push_back(name);
      else if (is_of_contact_only(name))
        left_out.push_back(name);
      else if (!read_column(c, measurement))
        left_out.push_back(name);
    }
    drop_sums_and_zeros(measurement, left_out);
    require_times(measurement);
    if (!left_out.empty()) measurement.notes.push_back("not fitted: " + join(left_out));
  }

 private:
  static bool is_time(const std::string& name) { return name.starts_with("time_"); }
  static bool is_vector(const std::string& name) {
    return name.starts_with("reaction_") || name.starts_with("grab_") || name.starts_with("probe_");
  }
  // Of contact, but no force of a tool on the tissue.
  bool is_of_contact_only(const std::string& name) const {
    if (!name.starts_with("contact_")) return false;
    if (name.ends_with("_deepest_m") || name.ends_with("_Nm") || name.ends_with("_normal_N")) return true;
    return std::any_of(between_.begin(), between_.end(), [&](const std::string& of) { return name.starts_with(of); });
  }

  static bool is_displacement(const std::string& name) { return name.starts_with("displacement_"); }

  void read_times(std::size_t c) {
    const Unit& unit = unit_of(table_.names[c], Dimension::time);
    for (const std::vector<double>& row : table_.rows) times_.push_back(unit.size * row[c]);
  }

  // Of the one thing that the scene moves.
  void read_displacements(std::size_t c) {
    const std::string& name = table_.names[c];
    const Unit& unit = unit_of(name, Dimension::length);
    const Drive drive(model_, where_ + ": column " + name);
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      const double distance = unit.size * table_.rows[r][c];
      const std::optional<double> time = distance >= 0 ? drive.time_of(distance) : std::nullopt;
      if (!time)
        throw Error(where_, "row " + std::to_string(r + 1) + " has the displacement " + number(distance) + " m",
                    "expected 0 to " + number(drive.farthest()) + " m, as far as the scene moves");
      times_.push_back(*time);
    }
  }

  const Unit& unit_of(const std::string& name, Dimension dimension) const {
    const std::string text = name.substr(name.rfind('_') + 1);
    const Unit* unit = find_unit(text);
    if (!unit || unit->dimension != dimension)
      throw Error(where_, "column " + name + " has the unit \"" + text + "\"",
                  "expected " + unit_names(dimension) + " at the end of its name");
    return *unit;
  }

  // False: an unwanted column.
  bool read_column(std::size_t c, Measurement& measurement) {
    const std::string& name = table_.names[c];
    if (is_time(name) || is_displacement(name)) {
      if (!times_.empty()) throw Error(where_, "column " + name + " is a second time", "expected one");
      is_time(name) ? read_times(c) : read_displacements(c);
      return true;
    }
    const std::size_t end = name.rfind('_');  // before the unit
    const std::string stem = name.substr(0, end);
    const int axis = stem.size() < 3 || stem[stem.size() - 2] != '_' ? -1 : stem.back() - 'x';
    if (end == std::string::npos || axis < 0 || axis > 2) throw unknown(name);
    const std::string vector = stem.substr(0, stem.size() - 2);
    const auto [kind, index] = measurand_of(vector, name);
    const Dimension dimension = kind == Kind::vertex ? Dimension::length : Dimension::force;
    const Unit& unit = unit_of(name, dimension);
    const auto wanted = [&](const std::string& column) { return column == stem || column == vector; };
    if (!how_.columns.empty() && std::none_of(how_.columns.begin(), how_.columns.end(), wanted)) return false;
    MeasuredCurve& curve = measurement.curves.emplace_back();
    curve = {stem, {kind, index, axis}, dimension, {}, {}, 0};
    for (const std::vector<double>& row : table_.rows) curve.values.push_back(unit.size * row[c]);
    return true;
  }

  Error unknown(const std::string& name) const {
    return Error(where_, "column \"" + name + "\" is no measurement", kNames);
  }

  std::pair<Kind, std::size_t> measurand_of(const std::string& vector, const std::string& name) const {
    if (vector == "reaction") return {Kind::reaction, 0};
    if (vector == "grab") return {Kind::grab, 0};
    if (vector == "probe") return {Kind::vertex, probe_};
    const auto after = [&](std::string_view prefix) { return std::string_view(vector).substr(prefix.size()); };
    if (vector.starts_with("vertex_"))
      return {Kind::vertex, index_below(after("vertex_"), model_.rest_positions.size(), "vertex", where_)};
    if (vector.starts_with("support_")) {
      const std::size_t supports = reference::support_forces(model_, initial_state(model_)).size();
      return {Kind::support, index_below(after("support_"), supports, "support", where_)};
    }
    if (!vector.starts_with("contact_")) throw unknown(name);
    std::vector<std::string> tools;
    for (const Tool& tool : model_.tools) tools.push_back(in_column(tool.name));
    const auto found = std::find(tools.begin(), tools.end(), after("contact_"));
    if (found == tools.end())
      throw Error(where_, "column " + name + " names no tool of the scene",
                  tools.empty() ? "expected none in this scene" : "expected one of " + join(tools));
    return {Kind::contact, static_cast<std::size_t>(found - tools.begin())};
  }

  // Leaves out vectors that are zero throughout, and the sum of all supports beside them.
  static void drop_sums_and_zeros(Measurement& measurement, std::vector<std::string>& left_out) {
    std::vector<MeasuredCurve>& curves = measurement.curves;
    const auto is_of = [](const MeasuredCurve& a, const Measurand& q) {
      return a.measurand.kind == q.kind && a.measurand.index == q.index;
    };
    const bool has_supports = std::any_of(curves.begin(), curves.end(),
                                          [](const MeasuredCurve& c) { return c.measurand.kind == Kind::support; });
    std::vector<MeasuredCurve> kept;
    for (const MeasuredCurve& curve : curves) {
      const bool zero = std::all_of(curves.begin(), curves.end(), [&](const MeasuredCurve& other) {
        return !is_of(other, curve.measurand) ||
               std::all_of(other.values.begin(), other.values.end(), [](double v) { return std::isnan(v) || v == 0; });
      });
      if (zero || (has_supports && curve.measurand.kind == Kind::reaction))
        left_out.push_back(curve.name);
      else
        kept.push_back(curve);
    }
    curves = std::move(kept);
  }

  void require_times(Measurement& measurement) const {
    if (times_.empty() && table_.rows.size() > 1)
      throw Error(where_, "has " + std::to_string(table_.rows.size()) + " rows and no times",
                  "expected a column time_s, or one row at the end");
    if (measurement.curves.empty()) throw Error(where_, "has no value other than 0 to fit", kNames);
    for (MeasuredCurve& curve : measurement.curves) {
      std::vector<double> values;
      for (std::size_t r = 0; r < curve.values.size(); ++r) {
        if (std::isnan(curve.values[r])) continue;
        if (!times_.empty()) {
          if (!(times_[r] >= 0))
            throw Error(where_, "row " + std::to_string(r + 1) + " has no time", "expected 0 or more");
          curve.times.push_back(times_[r]);
        }
        values.push_back(curve.values[r]);
      }
      curve.values = std::move(values);
    }
  }

  const Model& model_;
  const MeasurementRead& how_;
  MeasuredTable table_;
  std::uint32_t probe_;
  std::string where_;
  std::vector<double> times_;
  std::vector<std::string> between_;  // how columns of the forces between bodies begin
};

// The unit of the positions in the first line index,x_mm,y_mm,z_mm; m without one.
double size_of_unit(std::string_view header, const std::filesystem::path& file) {
  const std::size_t begin = header.find("x_");
  if (begin == std::string_view::npos) return 1;
  const std::string_view text = header.substr(begin + 2, header.find_first_of(", \r", begin) - begin - 2);
  const Unit* unit = find_unit(text);
  if (!unit || unit->dimension != Dimension::length)
    throw Error(file.string() + ":1", "positions have the unit \"" + std::string(text) + "\"",
                "expected " + unit_names(Dimension::length));
  return unit->size;
}

// Millimeters instead of meters are the usual mistake.
void require_size(const MeasuredShape& shape, const Model& model, const std::filesystem::path& file) {
  constexpr double kMost = 10;
  Eigen::AlignedBox3d measured, own;
  for (const Eigen::Vector3d& x : shape.positions) measured.extend(x);
  for (const Eigen::Vector3d& x : model.rest_positions) own.extend(x);
  if (shape.positions.size() < 3) return;
  const double ratio = measured.diagonal().norm() / own.diagonal().norm();
  if (ratio > kMost || ratio < 1 / kMost)
    throw Error(file.string(), "is " + number(ratio) + " times as large as the scene", "expected positions in meters");
}

MeasuredShape read_vertices(const std::filesystem::path& file, const std::string& content, const Model& model) {
  const double size = size_of_unit(std::string_view(content).substr(0, content.find('\n')), file);
  VertexTable table = read_vertex_csv_content(file, content, model.rest_positions.size());
  MeasuredShape shape;
  const std::vector<char> held = model.held();
  for (std::size_t r = 0; r < table.vertices.size(); ++r) {
    if (held[table.vertices[r]]) continue;
    shape.vertices.push_back(table.vertices[r]);
    shape.positions.push_back(size * table.values[r]);
  }
  if (shape.vertices.empty()) throw Error(file.string(), "has constrained vertices only", "expected free ones");
  return shape;
}

MeasuredShape read_points(const std::filesystem::path& file) {
  const ShapeFile read = read_shape(file);
  return {{}, read.surface ? read.surface->positions : read.tets.mesh.positions, 0};
}

}  // namespace

Measurement read_measurement(const std::filesystem::path& file, const Model& model, const MeasurementRead& how) {
  Measurement measurement;
  measurement.file = file;
  if (const std::string ending = lower_ending(file); ending != ".csv" && ending != ".txt" && !ending.empty()) {
    measurement.shapes.push_back(read_points(file));
  } else if (const std::string content = read_file(file); content.starts_with("index")) {
    measurement.shapes.push_back(read_vertices(file, content, model));
  } else {
    CurveReader(file, model, how).read(measurement);
  }
  for (const MeasuredShape& shape : measurement.shapes) require_size(shape, model, file);
  return measurement;
}

void assign_noise(std::vector<Measurement>& measurements, const std::vector<Noise>& noise, const Model& model) {
  const auto noise_of = [&](Dimension dimension, double largest) {
    Noise last;
    for (const Noise& entry : noise)
      if (entry.relative || entry.dimension == dimension) last = entry;
    return last.relative ? last.value * largest : last.value;
  };
  for (Measurement& measurement : measurements) {
    for (MeasuredCurve& curve : measurement.curves) {
      double largest = 0;
      for (const MeasuredCurve& other : measurement.curves)
        if (other.measurand.kind == curve.measurand.kind && other.measurand.index == curve.measurand.index)
          for (const double value : other.values) largest = std::max(largest, std::abs(value));
      curve.noise = noise_of(curve.dimension, largest);
    }
    for (MeasuredShape& shape : measurement.shapes) {
      double largest = 0;
      const std::vector<double> distances = distances_to(shape, model, initial_state(model).displacement);
      for (const double d : distances) largest = std::max(largest, std::abs(d));
      if (largest == 0) throw Error(measurement.file.string(), "is the shape at rest", "expected a deformed one");
      shape.noise = noise_of(Dimension::length, largest);
    }
  }
}

}  // namespace fascia
