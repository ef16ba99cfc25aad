// Tables of a benchmark as CSV files: lines "# ..." that describe the measurement, the column names, rows.
#pragma once
#include <concepts>
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

/// A text, an integer, or a number with the seven digits that are significant in float32 results. Empty: no value.
class Cell {
 public:
  Cell() = default;
  Cell(std::string text) : text_(std::move(text)) {}
  Cell(const char* text) : text_(text) {}
  Cell(std::integral auto number) : text_(std::to_string(number)) {}
  Cell(double number);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct Table {
  std::vector<std::string> notes;    // one line each
  std::vector<std::string> columns;  // name_unit
  std::vector<std::vector<Cell>> rows;
};

/// The columns and rows for readers, in columns of equal width.
std::string aligned(const Table& table);
/// Writes through a temporary name. Throws Error.
void write_table(const std::filesystem::path& path, const Table& table);

}  // namespace fascia
