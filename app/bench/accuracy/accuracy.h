// fascia bench accuracy: error against iterations and against wall time, for every valid solver choice.
#pragma once
#include "app/bench/accuracy/grid.h"
#include "app/bench/bench.h"

namespace fascia {

/// Writes accuracy.csv, accuracy.md and two charts for every case. Results in the folder's accuracy.csv of the same
/// version, machine and grid are reused, unless `fresh`; a case is written to the table as soon as it is complete.
/// Returns the number of measurements of a solver choice on a case. Throws Error or Interrupted.
int bench_accuracy(Bench& bench, const AccuracyGrid& grid, bool fresh);

}  // namespace fascia
