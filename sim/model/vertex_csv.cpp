#include "sim/model/vertex_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>

#include "base/csv/csv_line.h"
#include "base/error.h"
#include "base/file.h"

namespace fascia {
namespace {

template <class T>
std::optional<T> parse(std::string_view field) {
  T value;
  if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string copy = text.size() > kLongest ? std::string(text.substr(0, kLongest)) + "..." : std::string(text);
  for (char& c : copy) c = static_cast<unsigned char>(c) < ' ' ? '?' : c;
  return "\"" + copy + "\"";
}

struct Row {
  std::uint32_t vertex;
  std::size_t line;
  Eigen::Vector3d value;
};

// `fields`: index, x, y, z.
Row parse_row(const std::vector<std::string_view>& fields, const std::string& where, std::size_t vertex_count) {
  const auto index = parse<std::int64_t>(fields[0]);
  if (!index) throw Error(where, quoted(fields[0]) + " is not a vertex index", "expected index,x,y,z");
  if (*index < 0 || static_cast<std::size_t>(*index) >= vertex_count) {
    throw Error(where, "vertex " + std::to_string(*index) + " does not exist",
                "expected 0 to " + std::to_string(vertex_count - 1));
  }
  Row row{static_cast<std::uint32_t>(*index), 0, {}};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view field = fields[static_cast<std::size_t>(axis) + 1];
    const auto value = parse<double>(field);
    if (!value || !std::isfinite(*value)) {
      throw Error(where, std::string(1, "xyz"[axis]) + " is " + quoted(field), "expected a finite number");
    }
    row.value[axis] = *value;
  }
  return row;
}

}  // namespace

VertexTable read_vertex_csv(const std::filesystem::path& path, std::size_t vertex_count) {
  return read_vertex_csv_content(path, read_file(path), vertex_count);
}

VertexTable read_vertex_csv_content(const std::filesystem::path& path, std::string_view content,
                                    std::size_t vertex_count) {
  std::string_view rest = content;
  std::vector<Row> rows;
  bool may_be_header = true;
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    const std::size_t newline = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, newline));
    rest.remove_prefix(std::min(newline + 1, rest.size()));
    if (line.empty()) continue;
    const std::string where = path.string() + ":" + std::to_string(line_number);
    const std::vector<std::string_view> fields = csv_cells(line);
    if (fields.size() != 4) throw Error(where, quoted(line) + " does not have 4 fields", "expected index,x,y,z");
    const bool is_header = may_be_header && std::none_of(fields.begin(), fields.end(),
                                                         [](std::string_view f) { return parse<double>(f); });
    may_be_header = false;
    if (is_header) continue;
    rows.push_back(parse_row(fields, where, vertex_count));
    rows.back().line = line_number;
  }
  if (rows.empty()) throw Error(path.string(), "has no rows", "expected lines index,x,y,z");

  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.vertex < b.vertex; });
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (rows[r].vertex != rows[r - 1].vertex) continue;
    throw Error(
        path.string() + ":" + std::to_string(rows[r].line),
        "vertex " + std::to_string(rows[r].vertex) + " stands on line " + std::to_string(rows[r - 1].line) + " already",
        "expected each vertex once");
  }
  VertexTable table;
  for (const Row& row : rows) {
    table.vertices.push_back(row.vertex);
    table.values.push_back(row.value);
  }
  return table;
}

std::vector<Eigen::Vector3d> read_complete_vertex_csv(const std::filesystem::path& path, std::size_t vertex_count) {
  return read_complete_vertex_csv(path, read_file(path), vertex_count);
}

std::vector<Eigen::Vector3d> read_complete_vertex_csv(const std::filesystem::path& path, std::string_view content,
                                                      std::size_t vertex_count) {
  VertexTable table = read_vertex_csv_content(path, content, vertex_count);
  if (table.vertices.size() == vertex_count) return std::move(table.values);
  std::size_t missing = 0;  // the first row that does not have the vertex of its number
  while (missing < table.vertices.size() && table.vertices[missing] == missing) ++missing;
  throw Error(path.string(),
              "misses " + std::to_string(vertex_count - table.vertices.size()) + " of " + std::to_string(vertex_count) +
                  " vertices, the first is " + std::to_string(missing),
              "expected a line for every vertex");
}

}  // namespace fascia
