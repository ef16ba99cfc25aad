#include "tests/drivers/kernel_table.h"

#include <algorithm>
#include <sstream>

#include "base/csv/csv_line.h"
#include "base/error.h"
#include "base/file.h"

namespace fascia::test {
namespace {

std::string name_of(const KernelName& kernel) {
  return kernel.first + (kernel.second.empty() ? "" : " [" + kernel.second + "]");
}

std::string spills_of(const IntelFigures& figures) {
  return std::to_string(figures.spills) + " spills and " + std::to_string(figures.fills) + " fills";
}

std::string header_of(const std::string& driver) {
  std::string header = "kernel,variant,LDS bytes";
  for (const char* chip : kChips) header += std::string(",") + chip + " registers," + chip + " waves";
  return header + ",TGL width,TGL instructions,TGL spills,TGL fills," + driver;
}

}  // namespace

std::vector<std::string> complaints(const KernelTable& table, const KernelTable& now) {
  std::vector<std::string> lines;
  for (const auto& [kernel, figures] : now) {
    const auto known = table.find(kernel);
    for (std::size_t c = 0; c < kChips.size(); ++c) {
      const std::string where = name_of(kernel) + " on " + kChips[c] + ": ";
      if (figures.chips[c].spills > 0) lines.push_back(where + "spills " + std::to_string(figures.chips[c].spills));
      if (known == table.end()) continue;
      const int before = known->second.chips[c].registers, registers = figures.chips[c].registers;
      if (registers > before + kMoreRegisters)
        lines.push_back(where + std::to_string(registers) + " registers instead of " + std::to_string(before));
    }
    const std::string where = name_of(kernel) + " on TGL: ";
    const IntelFigures& intel = figures.intel;
    const IntelFigures before = known == table.end() ? IntelFigures{} : known->second.intel;
    if (intel.width > 0 && intel.width < before.width)
      lines.push_back(where + "SIMD" + std::to_string(intel.width) + " instead of SIMD" + std::to_string(before.width));
    if (intel.spills > before.spills || intel.fills > before.fills)
      lines.push_back(where + spills_of(intel) + " instead of " + spills_of(before));
  }
  for (const auto& [kernel, figures] : now)
    if (!table.contains(kernel)) lines.push_back(name_of(kernel) + ": not in the table");
  for (const auto& [kernel, figures] : table)
    if (!now.contains(kernel)) lines.push_back(name_of(kernel) + ": in the table, but no solver links it");
  return lines;
}

StoredTable read_table(const std::filesystem::path& file) {
  std::istringstream in(read_file(file));
  std::string line;
  std::getline(in, line);
  StoredTable table{std::string(csv_cells(line).back()), {}};
  if (line != header_of(table.driver)) throw Error(file.string() + ": expected the columns " + header_of("DRIVER"));
  while (std::getline(in, line)) {
    const std::vector<std::string_view> cells = csv_cells(line);
    const auto number = [&](std::size_t i) { return std::stoi(std::string(cells.at(i))); };
    auto& [chips, intel] = table.kernels[{std::string(cells.at(0)), std::string(cells.at(1))}];
    for (std::size_t c = 0; c < kChips.size(); ++c) chips[c] = {number(3 + 2 * c), number(4 + 2 * c), number(2), 0};
    const std::size_t first = 3 + 2 * kChips.size();
    intel = {number(first), number(first + 1), number(first + 2), number(first + 3)};
  }
  return table;
}

void write_table(const std::filesystem::path& file, const StoredTable& table) {
  std::string text = header_of(table.driver) + "\n";
  for (const auto& [kernel, figures] : table.kernels) {
    text += kernel.first + "," + kernel.second + "," + std::to_string(figures.chips[0].lds_bytes);
    for (const ChipFigures& chip : figures.chips)
      text += "," + std::to_string(chip.registers) + "," + std::to_string(chip.waves);
    const IntelFigures& intel = figures.intel;
    for (const int figure : {intel.width, intel.instructions, intel.spills, intel.fills})
      text += "," + std::to_string(figure);
    text += "\n";
  }
  write_file(file, text);
}

std::vector<std::string> summary(const KernelTable& table, int least) {
  const auto registers = [](const auto& row) { return row->second.chips[0].registers; };
  std::map<std::string, KernelTable::const_iterator> most;  // by file
  for (auto it = table.begin(); it != table.end(); ++it) {
    const auto [found, fresh] = most.emplace(it->first.first, it);
    if (registers(it) > registers(found->second)) found->second = it;
  }
  std::vector<KernelTable::const_iterator> rows;
  for (const auto& [file, row] : most)
    if (registers(row) > least) rows.push_back(row);
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return registers(a) > registers(b); });
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line =
        "| `" + std::filesystem::path(row->first.first).stem().string() + "` | " + row->first.second + " |";
    for (const ChipFigures& chip : row->second.chips)
      line += " " + std::to_string(chip.registers) + " / " + std::to_string(chip.waves) + " |";
    const IntelFigures& intel = row->second.intel;
    lines.push_back(line + " " + std::to_string(intel.width) + " / " + std::to_string(intel.instructions) + " / " +
                    std::to_string(intel.spills) + " | " + std::to_string(row->second.chips[0].lds_bytes) + " |");
  }
  return lines;
}

}  // namespace fascia::test
