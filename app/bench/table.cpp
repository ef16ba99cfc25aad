#include "app/bench/table.h"

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
