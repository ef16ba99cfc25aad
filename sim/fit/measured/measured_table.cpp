#include "sim/fit/measured/measured_table.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "base/csv/csv_line.h"
#include "base/error.h"

namespace fascia {
namespace {

double value_of(std::string_view cell, const std::string& where, const std::string& name) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (problem != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw Error(where, name + " is \"" + std::string(cell) + "\"", "expected a finite number or an empty cell");
  return value;
}

}  // namespace

MeasuredTable read_measured_table(const std::filesystem::path& file, std::string_view content) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  MeasuredTable table;
  for (std::size_t number = 1; !content.empty(); ++number) {
    const std::size_t newline = std::min(content.find('\n'), content.size());
    const std::string_view line = trimmed(content.substr(0, newline));
    content.remove_prefix(std::min(newline + 1, content.size()));
    if (line.empty()) continue;
    if (line.front() == '#') {
      const std::size_t colon = std::min(line.find(':'), line.size());
      if (colon < line.size())
        table.notes.emplace_back(trimmed(line.substr(1, colon - 1)), trimmed(line.substr(colon + 1)));
      continue;
    }
    const std::string where = file.string() + ":" + std::to_string(number);
    const std::vector<std::string_view> cells = csv_cells(line);
    if (table.names.empty()) {
      table.header_line = number;
      table.names.assign(cells.begin(), cells.end());
      continue;
    }
    if (cells.size() != table.names.size())
      throw Error(
          where, "has " + std::to_string(cells.size()) + " cells",
          "expected " + std::to_string(table.names.size()) + " as in line " + std::to_string(table.header_line));
    std::vector<double>& row = table.rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) row.push_back(value_of(cells[c], where, table.names[c]));
  }
  if (table.rows.empty())
    throw Error(file.string(), "has no rows of values",
                "expected a line of names such as time_s,reaction_y_N and rows");
  return table;
}

}  // namespace fascia
