#include "app/bench/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "base/file.h"

namespace fascia {
Cell::Cell(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.7g", number);
  text_ = std::isfinite(number) ? digits : "nan";
}

std::string aligned(const Table& table) {
  std::vector<std::vector<Cell>> rows{{table.columns.begin(), table.columns.end()}};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const std::vector<Cell>& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].text().size());
  std::string text;
  for (const std::vector<Cell>& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      text += std::string(widths[c] - row[c].text().size() + (c ? 2 : 0), ' ') + row[c].text();
    text += '\n';
  }
  return text;
}

void write_table(const std::filesystem::path& path, const Table& table) {
  write_file(path, [&](std::ostream& out) {
    for (const std::string& note : table.notes) out << "# " << note << '\n';
    for (std::size_t c = 0; c < table.columns.size(); ++c) out << (c ? "," : "") << table.columns[c];
    out << '\n';
    for (const std::vector<Cell>& row : table.rows) {
      assert(row.size() == table.columns.size());
      for (std::size_t c = 0; c < row.size(); ++c) out << (c ? "," : "") << row[c].text();
      out << '\n';
    }
  });
}

}  // namespace fascia
