#include "app/bench/accuracy/results.h"

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <type_traits>

#include "base/error.h"
#include "base/file.h"

namespace fascia {
namespace {

const std::vector<std::string> kResultColumns{"scenario",   "tets",     "young_modulus", "poisson_ratio",
                                              "time_step",  "substeps", "method",        "acceleration",
                                              "iterations", "error",    "ms_median",     "ms_min"};
constexpr std::size_t kKeyCells = 8;  // columns that identify solver choice and case

std::vector<Cell> key_cells(const AccuracyCase& measured, const SolverChoice& pair) {
  const double time_step = settings_of(measured, pair, 1).time_step;
  return {
      name_of(measured.scenario), measured.tets(),      measured.young_modulus,    measured.poisson_ratio, time_step,
      measured.substeps,          name_of(pair.method), name_of(pair.acceleration)};
}

std::string line_of(const std::vector<std::string>& cells, std::size_t count) {
  std::string line;
  for (std::size_t c = 0; c < count; ++c) line += (c ? "," : "") + cells[c];
  return line;
}

std::string key_of(const AccuracyCase& measured, const SolverChoice& pair) {
  std::vector<std::string> texts;
  for (const Cell& cell : key_cells(measured, pair)) texts.push_back(cell.text());
  return line_of(texts, texts.size());
}

Cell milliseconds(double ms) { return std::isfinite(ms) ? Cell(ms) : Cell(); }

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// False unless the whole text is a number; an empty text is NaN.
template <class Number>
bool parse(const std::string& text, Number& number) {
  if constexpr (std::is_floating_point_v<Number>)
    if (text.empty()) {
      number = std::numeric_limits<Number>::quiet_NaN();
      return true;
    }
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, number);
  return problem == std::errc() && stop == end;
}

bool parse(const std::vector<std::string>& cells, AccuracyPoint& point) {
  return cells.size() == kResultColumns.size() && parse(cells[kKeyCells], point.iterations) &&
         parse(cells[kKeyCells + 1], point.error) && parse(cells[kKeyCells + 2], point.ms_median) &&
         parse(cells[kKeyCells + 3], point.ms_min);
}

// Whether all numbers of iterations are present, in order; the rest may be missing after a state that was not finite.
bool complete(const std::vector<AccuracyPoint>& points, const std::vector<int>& iterations) {
  if (points.empty() || points.size() > iterations.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].iterations != iterations[i]) return false;
  return points.size() == iterations.size() || std::isnan(points.back().error);
}

using PointsByKey = std::map<std::string, std::vector<AccuracyPoint>>;

PointsByKey read_points(const std::filesystem::path& path, const std::vector<std::string>& notes) {
  std::istringstream in(read_file(path));
  PointsByKey points;
  std::vector<std::string> notes_read;
  bool header = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string where = path.string() + ":" + std::to_string(++number);
    if (!header && line.rfind("# ", 0) == 0) {
      notes_read.push_back(line.substr(2));
    } else if (!header) {
      header = true;
      if (line != line_of(kResultColumns, kResultColumns.size()))
        throw Error(where, "has other columns",
                    "expected " + line_of(kResultColumns, kResultColumns.size()) + "; --fresh starts over");
    } else {
      const std::vector<std::string> cells = split(line);
      AccuracyPoint point;
      if (!parse(cells, point))
        throw Error(where, "cannot be read", "expected the numbers of a measurement; --fresh starts over");
      points[line_of(cells, kKeyCells)].push_back(point);
    }
  }
  if (notes_read != notes)
    throw Error(path.string(), "is from another version, machine or set of measurements",
                "expected the same notes at its top; choose another folder, or start over with --fresh");
  return points;
}

}  // namespace

AccuracyResults empty_results(const AccuracyGrid& grid) {
  AccuracyResults results;
  for (const AccuracyCase& measured : grid.cases) {
    results.push_back({measured, {}});
    for (const SolverChoice& pair : grid.pairs_of(measured)) results.back().pairs.push_back({pair, {}});
  }
  return results;
}

Table table_of(const AccuracyResults& results, const std::vector<std::string>& notes) {
  Table table{notes, kResultColumns, {}};
  for (const CaseAccuracy& c : results)
    for (const PairAccuracy& p : c.pairs)
      for (const AccuracyPoint& point : p.points) {
        std::vector<Cell> row = key_cells(c.measured, p.pair);
        row.insert(row.end(),
                   {point.iterations, point.error, milliseconds(point.ms_median), milliseconds(point.ms_min)});
        table.rows.push_back(std::move(row));
      }
  return table;
}

AccuracyResults read_results(const std::filesystem::path& path, const AccuracyGrid& grid,
                             const std::vector<std::string>& notes) {
  const PointsByKey points = read_points(path, notes);
  AccuracyResults results = empty_results(grid);
  for (CaseAccuracy& c : results)
    for (PairAccuracy& p : c.pairs) {
      const auto found = points.find(key_of(c.measured, p.pair));
      if (found != points.end() && complete(found->second, grid.iterations_of(c.measured))) p.points = found->second;
    }
  return results;
}

}  // namespace fascia
