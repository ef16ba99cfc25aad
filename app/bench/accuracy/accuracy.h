// fascia bench accuracy: error against iterations and against wall time, for every legal pair of method and
// acceleration.
#pragma once
#include "app/bench/accuracy/grid.h"
#include "app/bench/bench.h"

namespace fascia {

/// Writes accuracy.csv, accuracy.md and two charts for every case. What an accuracy.csv of the same version, machine
/// and grid in the folder holds is not measured again, unless `fresh`; a case is in the table as soon as it is done.
/// Returns how often a pair was measured on a case. Throws Error or Interrupted.
int bench_accuracy(Bench& bench, const AccuracyGrid& grid, bool fresh);

}  // namespace fascia
