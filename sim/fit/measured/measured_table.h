// A CSV file of measured curves as its cells: names of columns with their units, and numbers.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fascia {

struct MeasuredTable {
  std::vector<std::pair<std::string, std::string>> notes;  // lines "# keyword: text"
  std::size_t header_line = 0;
  std::vector<std::string> names;         // [column]
  std::vector<std::vector<double>> rows;  // [row][column] NaN: an empty cell
};

/// Throws Error "file:line: ..." for a row of another number of cells and for a cell that is no finite number.
MeasuredTable read_measured_table(const std::filesystem::path& file, std::string_view content);

}  // namespace fascia
