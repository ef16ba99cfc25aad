#include "app/bench/speed_table.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/csv/csv_line.h"
#include "base/error.h"
#include "base/file.h"

namespace fascia {
std::vector<SpeedRow> read_speeds(const std::filesystem::path& path) {
  std::istringstream in(read_file(path));
  std::vector<SpeedRow> rows;
  std::vector<std::string> columns;
  long number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto fail = [&](const std::string& what) {
      throw Error(path.string() + ":" + std::to_string(number), what, "expected a speed.csv of fascia bench speed");
    };
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string_view> cells = csv_cells(line);
    if (columns.empty()) {
      columns.assign(cells.begin(), cells.end());
      continue;
    }
    const auto text = [&](const std::string& name) {
      const auto at = std::find(columns.begin(), columns.end(), name);
      if (at == columns.end()) fail("no column " + name);
      const auto index = static_cast<std::size_t>(at - columns.begin());
      if (index >= cells.size()) fail("no " + name);
      return std::string(cells[index]);
    };
    const auto value = [&](const std::string& name) {
      const std::string cell = text(name);
      double number_read = 0;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number_read);
      if (error != std::errc() || end != cell.data() + cell.size() || !(number_read > 0)) fail(name + " is " + cell);
      return number_read;
    };
    rows.push_back({text("tets") + " tets, " + text("method") + " + " + text("acceleration"),
                    {value("ms_per_step"), value("ms_per_step_low"), value("ms_per_step_high")}});
  }
  if (rows.empty()) throw Error(path.string(), "has no rows", "expected a speed.csv of fascia bench speed");
  return rows;
}

std::vector<SpeedChange> compare_speeds(const std::vector<SpeedRow>& then, const std::vector<SpeedRow>& now) {
  constexpr double kTolerated = 1.1;
  std::vector<SpeedChange> changes;
  for (const SpeedRow& row : now) {
    const auto old = std::find_if(then.begin(), then.end(), [&](const SpeedRow& r) { return r.name == row.name; });
    if (old == then.end()) continue;
    changes.push_back({row.name, row.ms.median / old->ms.median,
                       row.ms.median > kTolerated * old->ms.median && row.ms.low > old->ms.high});
  }
  return changes;
}

}  // namespace fascia
