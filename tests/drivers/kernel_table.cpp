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

std::string header_of(const std::string& driver) {
  std::string header = "kernel,variant,LDS bytes";
  for (const char* chip : kChips) header += std::string(",") + chip + " registers," + chip + " waves";
  return header + "," + driver;
}

}  // namespace

std::vector<std::string> complaints(const KernelTable& table, const KernelTable& now) {
  std::vector<std::string> lines;
  for (const auto& [kernel, chips] : now)
    for (std::size_t c = 0; c < kChips.size(); ++c) {
      const std::string where = name_of(kernel) + " on " + kChips[c] + ": ";
      if (chips[c].spills > 0) lines.push_back(where + "spills " + std::to_string(chips[c].spills));
      const auto known = table.find(kernel);
      if (known == table.end()) continue;
      const int before = known->second[c].registers, registers = chips[c].registers;
      if (registers > before + kMoreRegisters)
        lines.push_back(where + std::to_string(registers) + " registers instead of " + std::to_string(before));
    }
  for (const auto& [kernel, chips] : now)
    if (!table.contains(kernel)) lines.push_back(name_of(kernel) + ": not in the table");
  for (const auto& [kernel, chips] : table)
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
    auto& chips = table.kernels[{std::string(cells.at(0)), std::string(cells.at(1))}];
    for (std::size_t c = 0; c < kChips.size(); ++c) chips[c] = {number(3 + 2 * c), number(4 + 2 * c), number(2), 0};
  }
  return table;
}

void write_table(const std::filesystem::path& file, const StoredTable& table) {
  std::string text = header_of(table.driver) + "\n";
  for (const auto& [kernel, chips] : table.kernels) {
    text += kernel.first + "," + kernel.second + "," + std::to_string(chips[0].lds_bytes);
    for (const ChipFigures& chip : chips)
      text += "," + std::to_string(chip.registers) + "," + std::to_string(chip.waves);
    text += "\n";
  }
  write_file(file, text);
}

std::vector<std::string> summary(const KernelTable& table, int least) {
  std::map<std::string, KernelTable::const_iterator> most;  // by file
  for (auto it = table.begin(); it != table.end(); ++it) {
    const auto [found, fresh] = most.emplace(it->first.first, it);
    if (it->second[0].registers > found->second->second[0].registers) found->second = it;
  }
  std::vector<KernelTable::const_iterator> rows;
  for (const auto& [file, row] : most)
    if (row->second[0].registers > least) rows.push_back(row);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a->second[0].registers > b->second[0].registers; });
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line =
        "| `" + std::filesystem::path(row->first.first).stem().string() + "` | " + row->first.second + " |";
    for (const ChipFigures& chip : row->second)
      line += " " + std::to_string(chip.registers) + " / " + std::to_string(chip.waves) + " |";
    lines.push_back(line + " " + std::to_string(row->second[0].lds_bytes) + " |");
  }
  return lines;
}

}  // namespace fascia::test
