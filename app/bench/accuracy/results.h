// The results of `fascia bench accuracy` so far, and their table, from which an interrupted run continues.
#pragma once
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "app/bench/accuracy/grid.h"
#include "app/bench/table.h"

namespace fascia {

struct AccuracyPoint {
  int iterations = 0;                                                               // per substep
  double error = std::numeric_limits<double>::quiet_NaN();                          // NaN: not finite
  double ms_median = std::numeric_limits<double>::quiet_NaN(), ms_min = ms_median;  // [ms] of a step; NaN: not timed
};

struct PairAccuracy {
  SolverChoice pair;
  std::vector<AccuracyPoint> points;  // by iterations; empty: not measured yet
};

struct CaseAccuracy {
  AccuracyCase measured;
  std::vector<PairAccuracy> pairs;
};

using AccuracyResults = std::vector<CaseAccuracy>;

/// An entry for everything in the grid, without measurements.
AccuracyResults empty_results(const AccuracyGrid& grid);

/// The measured solver choices.
Table table_of(const AccuracyResults& results, const std::vector<std::string>& notes);

/// Reads the results from a table that write_table() wrote from table_of(); an entry with missing numbers of iterations
/// is left empty. Throws Error if the table cannot be read, or if its notes differ, that is, for another version,
/// machine or grid.
AccuracyResults read_results(const std::filesystem::path& path, const AccuracyGrid& grid,
                             const std::vector<std::string>& notes);

}  // namespace fascia
