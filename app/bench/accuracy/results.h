// What `fascia bench accuracy` has measured so far, and its table, from which an interrupted run goes on.
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
  std::vector<AccuracyPoint> points;  // by iterations; empty: to be measured
};

struct CaseAccuracy {
  AccuracyCase measured;
  std::vector<PairAccuracy> pairs;
};

using AccuracyResults = std::vector<CaseAccuracy>;

/// A place for everything in the grid, nothing measured.
AccuracyResults empty_results(const AccuracyGrid& grid);

/// The pairs that are measured.
Table table_of(const AccuracyResults& results, const std::vector<std::string>& notes);

/// The results in a table that write_table() made of table_of(); a pair of a case that misses numbers of iterations is
/// left empty. Throws Error when the table cannot be read, or its notes are others: then it is from another version,
/// machine or grid.
AccuracyResults read_results(const std::filesystem::path& path, const AccuracyGrid& grid,
                             const std::vector<std::string>& notes);

}  // namespace fascia
